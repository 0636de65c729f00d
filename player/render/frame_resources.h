#pragma once
#include <optional>
#include <string>

#include "player/render/field_values.h"
#include "player/render/passes/cluster_draws.h"
#include "player/render/passes/frame_targets.h"
#include "player/render/passes/hole_filling.h"
#include "player/render/passes/photo_passes.h"
#include "player/render/passes/point_pass.h"
#include "player/render/passes/surface_pass.h"
#include "player/render/passes/transparent_pass.h"
#include "player/render/render_trials.h"
#include "player/render/scene_parts.h"
#include "player/render/timing/pass_clock.h"

namespace vantage {

/// Resources for drawing a package's frames: its model, photos and points in graphics memory, and render
/// targets. Must be used on the OpenGL thread. The package must outlive it.
struct FrameResources {
    FrameResources(const PackageReader& package, const MemoryBudget& budget);
    FrameResources(const FrameResources&) = delete;
    FrameResources& operator=(const FrameResources&) = delete;

    const PackageReader& package;
    const bool software;          ///< rendering on the CPU
    const bool layers_by_vertex;  ///< vertex shaders can select the layer
    RenderTrials trials;          ///< take effect in the next frame
    PlanScene scene;
    PhotoStore store;
    FieldValues fields;
    ClusterDraws clusters;
    SurfacePass surface;
    SceneParts parts;
    PhotoPasses photos;
    std::optional<PointPass> points;             ///< if there is a cloud
    std::optional<TransparentPass> transparent;  ///< if some of the mesh is transparent
    std::optional<HoleFilling> filling;          ///< if there is a background
    FrameTargets targets;                        ///< targets of the last frame
    PassClock pass_clock{};                      ///< off unless started by a measurement

    /// The reason why a server recently failed to deliver requested data; empty if it did not fail, or if the
    /// package is a local file.
    std::string failure() const;
};

/// Whether a frame shows transparent surfaces and its first plan has some in view. Only color pictures show
/// transparent surfaces, which would falsify counts and false colors.
bool shows_transparent(const FrameResources& resources, const RenderSettings& settings, const ViewPlan& plan);

/// How a frame's bare surfaces are drawn; for two eyes, this depends on the trials. Never returns
/// `automatic`.
EyeSurfaces eye_surfaces(const FrameResources& resources, const RenderSettings& settings, std::size_t eyes);

}  // namespace vantage
