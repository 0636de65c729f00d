#pragma once
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/text/error.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/scene_input.h"
#include "pipeline/prepare/resources.h"
#include "pipeline/reports/inspect/camera_facts.h"
#include "pipeline/reports/inspect/photo_facts.h"
#include "pipeline/reports/inspect/scale_facts.h"
#include "pipeline/reports/inspect/shape_facts.h"
#include "pipeline/run/settings.h"
#include "scene/package/contents/effects.h"

namespace vantage {

/// The facts about an input that are known before it is prepared. A part is missing here if the input does
/// not have it or if it cannot be read.
struct InputFacts {
    InputFiles files;
    std::optional<ShapeFacts> mesh{}, points{};  ///< `points`: all clouds together
    std::string camera_format{};                 ///< display name
    std::optional<CameraFacts> cameras{};        ///< only the cameras of usable photos if there is a scene
    std::optional<PhotoFacts> photos{};
    std::vector<std::string> warnings{};

    /// Present only if the scene can be read.
    struct Scene {
        struct ImageSet {
            std::string name;
            std::size_t photos;
        };
        std::size_t photos = 0;            ///< usable photos
        std::vector<ImageSet> image_sets;  ///< empty if there is only one
        std::optional<ScaleFacts> scale;
    };
    std::optional<Scene> scene{};
    std::vector<UnusablePhoto> skipped{};  ///< if there is no scene, the photos that cannot be read

    /// Present only if the scene can be prepared, or if the mesh is misplaced.
    struct Plan {
        std::vector<std::string> not_seeing;  ///< names of photos that do not see the mesh
        std::vector<EffectDecision> effects;  ///< effects that depend on all photos are undecided
        ResourceEstimate needs{};
    };
    std::optional<Plan> plan{};

    std::optional<Error> error{};  ///< the error with which `prepare` would fail

    /// The exit code that `prepare` would have: the code of the error, Exit::incomplete if photos are
    /// skipped, or Exit::ok.
    Exit exit() const;
};

/// Inspects an input without preparing it: reads the mesh, the cameras and the photos' headers, and writes
/// nothing. `settings`, `out` and `start`: the settings, the package and the start time that the preparation
/// would have. Errors in the input are part of the result.
InputFacts input_facts(const FoundInput& found, const PrepareSettings& settings,
                       const std::filesystem::path& out, std::chrono::steady_clock::time_point start);

}  // namespace vantage
