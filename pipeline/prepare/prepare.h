#pragma once
#include <array>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "pipeline/input/scene_input.h"
#include "pipeline/prepare/resources.h"
#include "pipeline/run/settings.h"
#include "pipeline/run/until_stopped.h"
#include "scene/package/package_format.h"
#include "scene/package/package_writer.h"

namespace vantage {

class IdentityCache;
class Trace;
struct Agreement;

/// Options for a run that do not change the package.
struct PrepareRun {
    const std::atomic<bool>* stop = nullptr;                     ///< when set, no further photos are started
    bool strict = false;                                         ///< an unusable photo ends the run
    IdentityCache* identities = nullptr;                         ///< null: the user's default cache
    Share share{};                                               ///< the photos to process; default: all
    Trace* trace = nullptr;                                      ///< records each thread's work
    std::function<void(const ResourceEstimate&)> on_estimate{};  ///< called before the first photo is started
    bool expect_view = false;  ///< whether to call expect_mesh_in_view(), which may throw Error(misplaced)
    std::chrono::steady_clock::time_point start =
        std::chrono::steady_clock::now();  ///< start of the run; the estimated time is counted from here
};

/// The result of a run.
struct PrepareResult {
    struct Stage {
        std::size_t made = 0, kept = 0;
        std::map<std::string, std::vector<std::string>> why;  ///< reason, and photos to which it applies
    };
    std::array<Stage, std::size_t(package::Stage::count)> stages;
    std::vector<UnusablePhoto> skipped;
    std::shared_ptr<const Agreement> agreement;  ///< null for a shard
};

/// Prepares the package `out` from `scene`. Photos are processed separately, at most `threads` at a time. The
/// same inputs and settings give the same bytes, no matter how often the run is interrupted and resumed.
/// Finished work is kept in FILE.part, and everything in an existing package that was made from the same
/// inputs is reused. The file appears under its name only when it is complete. Throws Error; if the run is
/// stopped, Error(interrupted).
PrepareResult prepare(SceneInput scene, const PrepareSettings& settings, const std::filesystem::path& out,
                      const OnProgress& progress, const PrepareRun& run = {});

}  // namespace vantage
