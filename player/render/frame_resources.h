#pragma once
#include <optional>
#include <string>

#include "player/render/passes/cluster_draws.h"
#include "player/render/passes/field_values.h"
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

/// What a package's frames are drawn from and into: its model, photos and points in graphics memory, and
/// render targets. Belongs to the OpenGL thread; the package must outlive it.
struct FrameResources {
    FrameResources(const PackageReader& package, const MemoryBudget& budget);
    FrameResources(const FrameResources&) = delete;
    FrameResources& operator=(const FrameResources&) = delete;

    const PackageReader& package;
    const bool software;          ///< frames are drawn by the processor
    const bool layers_by_vertex;  ///< a vertex can choose the layer that it is drawn into
    RenderTrials trials;          ///< apply from the next frame
    PlanScene scene;
    PhotoStore store;
    FieldValues fields;
    ClusterDraws clusters;
    SurfacePass surface;
    SceneParts parts;
    PhotoPasses photos;
    std::optional<PointPass> points;             ///< if there is a cloud
    std::optional<TransparentPass> transparent;  ///< if some of the mesh is not opaque
    std::optional<HoleFilling> filling;          ///< if there is a background
    FrameTargets targets;                        ///< of the last frame
    PassClock pass_clock{};                      ///< off unless a measurement starts it

    /// Why a server did not give all that was requested recently; empty if it did, and for a file.
    std::string failure() const;
};

/// Whether a frame shows transparent surfaces, of which its first plan has some in view. Only in colors:
/// between counts or false colors, others would say what is not so.
bool shows_transparent(const FrameResources& resources, const RenderSettings& settings, const ViewPlan& plan);

/// How the bare surfaces of a frame are drawn: of two eyes as the trials say; never automatic.
EyeSurfaces eye_surfaces(const FrameResources& resources, const RenderSettings& settings, std::size_t eyes);

}  // namespace vantage
