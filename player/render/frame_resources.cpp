#include "player/render/frame_resources.h"

#include <algorithm>

#include "base/gl/context.h"
#include "scene/package/contents/point_cloud.h"

namespace vantage {
namespace {

/// Memory for points, in bytes: at most a quarter of the limit, if one is set.
std::uint64_t points_memory(const MemoryBudget& budget) {
    return budget.graphics ? std::min(PointStore::max_bytes, budget.graphics / 4) : PointStore::max_bytes;
}

}  // namespace

FrameResources::FrameResources(const PackageReader& p, const MemoryBudget& budget)
    : package(p),
      software(gl::current_device().software),
      layers_by_vertex(epoxy_has_gl_extension("GL_ARB_shader_viewport_layer_array")),
      scene(make_plan_scene(p)),
      // With a software renderer, a frame's uploads are complete when the next one begins.
      store(p, software ? budget.ring / 2 : budget.ring),
      fields(p),
      clusters(p, scene),
      surface(p, scene, clusters, fields),
      photos(p, scene, store, clusters, parts, trials) {
    if (auto cloud = read_point_cloud(p)) points.emplace(p, std::move(*cloud), points_memory(budget));
    parts = {!points_only(p.scene()), !scene.photos.empty(), points.has_value(), scene.has_background()};
    if (scene.has_background()) filling.emplace();
    if (scene.has_transparency())
        transparent.emplace(budget.graphics ? budget.graphics / 4 : TransparentPass::max_list_bytes);
}

std::string FrameResources::failure() const {
    const std::string of_points = points ? points->failure() : std::string();
    return of_points.empty() ? store.failure() : of_points;
}

bool shows_transparent(const FrameResources& r, const RenderSettings& settings, const ViewPlan& plan) {
    const bool hidden = shows_points(settings, r.parts) && settings.points.alone;
    return r.transparent && r.transparent->mode() != Transparency::off && !hidden &&
           settings.show == Show::colors && !plan.in_view().transparent.empty();
}

/// Ignores temporary content, since reallocating targets evicts tiles. Both eyes are drawn at once only if
/// photos are blended by triangle: otherwise the redrawn model would have to match the surface's depth
/// exactly. In raking light, each eye has its own shadow map.
EyeSurfaces eye_surfaces(const FrameResources& r, const RenderSettings& settings, std::size_t eyes) {
    const bool transparent = r.transparent && settings.transparency != Transparency::off;
    if (eyes < 2 || transparent || !r.parts.mesh) return EyeSurfaces::in_turn;
    const bool can = r.layers_by_vertex && r.photos.by_triangle(settings) && !casts_shadows(settings);
    switch (r.trials.eye_surfaces) {
        case EyeSurfaces::automatic:
            return r.software ? EyeSurfaces::overlapped : can ? EyeSurfaces::at_once : EyeSurfaces::in_turn;
        case EyeSurfaces::at_once:
            return can ? EyeSurfaces::at_once : EyeSurfaces::overlapped;
        default:
            return r.trials.eye_surfaces;
    }
}

}  // namespace vantage
