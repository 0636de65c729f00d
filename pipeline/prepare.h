#pragma once
#include <array>
#include <atomic>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "pipeline/progress.h"
#include "pipeline/scene_input.h"
#include "pipeline/stages/border.h"
#include "pipeline/stages/undistort.h"
#include "scene/effects.h"
#include "scene/package_format.h"
#include "scene/package_writer.h"

namespace vantage {

class IdentityCache;
class Trace;
struct Agreement;

/// What renders the model from the photos' cameras; automatic: a graphics card where there is one.
enum class RenderBy { automatic, opengl, processor };
const char* name(RenderBy by);
/// Throws Error(usage).
RenderBy render_by(const std::string& name);

/// Settings of `vantage prepare`; every one is a point on a curve of accuracy against time.
struct PrepareSettings {
    DistanceMethod distance = DistanceMethod::automatic;
    RenderBy render_by = RenderBy::automatic;
    double border_width = 64;        ///< px at a photo 3072 px wide: where the border mask reaches 1
    double border_threshold = 0.01;  ///< depth step relative to depth, per pixel of the masks
    int thumbnail = 512;             ///< px on the long side
    int photo_size = 0;              ///< px on the long side that photos are reduced to; 0: as they are
    Resampling resampling = Resampling::cubic;  ///< of photos whose lens bends lines
    unsigned cluster_triangles = 256;
    unsigned threads = 0;      ///< 0: all cores; also the number of photos in flight
    std::uint64_t memory = 0;  ///< bytes that must do, by having fewer photos in flight; 0: any
    std::vector<std::string> hold_out;
    std::map<Effect, EffectChoice> effects;
};

/// What a preparation will take, known before its photos are begun.
struct Needs {
    std::uint64_t disk, disk_free;  ///< bytes
    std::uint64_t memory;           ///< bytes at most
    unsigned in_flight;             ///< photos at a time
    double seconds;                 ///< where nothing can be kept
};

/// How a run goes about it; the package does not depend on it.
struct PrepareRun {
    const std::atomic<bool>* stop = nullptr;  ///< set: the photos in hand are finished, and no more begun
    bool strict = false;                      ///< a photo that cannot be used ends the run
    IdentityCache* identities = nullptr;      ///< what is known of files; null: the user's usual cache
    Share share{};                            ///< of the photos; all, where it is not given
    Trace* trace = nullptr;                   ///< to be told when what was done
    std::function<void(const Needs&)> needs;  ///< told before the photos are begun
};

/// What a run did.
struct PrepareResult {
    struct Stage {
        std::size_t made = 0, kept = 0;
        std::map<std::string, std::vector<std::string>> why;  ///< reason: photos it was made for
    };
    std::array<Stage, std::size_t(package::Stage::count)> stages;
    std::vector<UnusablePhoto> left_out;
    std::shared_ptr<const Agreement> agreement;  ///< of all photos; none of a share
};

/// Prepares the package `out` from `scene`. Work is per photo: at most `threads` photos are in memory. The
/// same inputs and settings give the same bytes, however often the run is cut off and gone on with: what is
/// done is kept in FILE.part, and of a finished package all that was made from the same. The file appears
/// only when whole. Throws Error; Error(interrupted) when stopped.
PrepareResult prepare(SceneInput scene, const PrepareSettings& settings, const std::filesystem::path& out,
                      const std::function<void(const Progress&)>& progress, const PrepareRun& run = {});

}  // namespace vantage
