#include "player/render/passes/drawn_view.h"

#include <algorithm>

#include "player/render/frame_resources.h"
#include "player/render/planning/image_set_plans.h"

namespace vantage {
namespace {

/// The depth range of the model and of visible points.
Eigen::Vector2d depth_range_of(const FrameResources& r, const View& view, const RenderSettings& settings,
                               const ClustersInView& in_view) {
    const double reach = model_reach(r.package.scene(), view.cam_from_origin);
    std::vector<std::uint32_t> all;
    if (!in_view.transparent.empty()) {
        all = in_view.opaque;
        all.insert(all.end(), in_view.transparent.begin(), in_view.transparent.end());
    }
    const Eigen::Vector2d model =
        depth_range(r.scene.clusters, all.empty() ? in_view.opaque : all, view, reach);
    const Eigen::Vector2d anything(1, 2);
    if (!shows_points(settings, r.parts)) return model.y() > 0 ? model : anything;
    const Eigen::Vector2d cloud = r.points->range(view, reach);
    if (!(model.y() > 0)) return cloud.y() > 0 ? cloud : anything;
    if (!(cloud.y() > 0)) return model;
    return {std::min(model.x(), cloud.x()), std::max(model.y(), cloud.y())};
}

/// The distance within which a tenth of the mesh's clusters in view lie, in scene units.
double nearness(const PlanScene& scene, const View& view, std::span<const std::uint32_t> clusters) {
    const Eigen::Vector3d eye = view.cam_from_origin.center();
    std::vector<double> distances;
    for (const std::uint32_t c : clusters)
        if (c < scene.first_surrounding) distances.push_back((center(scene.clusters[c]) - eye).norm());
    if (distances.empty()) return 0;
    const auto tenth = distances.begin() + std::ptrdiff_t(distances.size() / 10);
    std::ranges::nth_element(distances, tenth);
    return *tenth;
}

}  // namespace

DrawnView drawn_view(const FrameResources& r, const View& view, const ImageSetFrame& image_set, int side,
                     bool coarse) {
    const RenderSettings& settings = image_set.settings;
    const bool weighted = settings.blend == Blend::average || settings.show == Show::coverage;
    const Eigen::Vector2d range = depth_range_of(r, view, settings, image_set.plan->in_view());
    return {view,
            settings,
            *image_set.plan,
            side,
            range,
            clip_from_origin(view, range).cast<float>(),
            weighted ? weights_in_image_set(settings.weights_from.value_or(view), settings.weights,
                                            settings.image_sets.shown, r.scene)
                     : std::vector<double>(),
            coarse};
}

bool suits_coarse(const FrameResources& r, const View& view, const ImageSetFrame& image_set) {
    constexpr double max_pixels = 1;  // in the enlarged frame
    const RenderSettings& settings = image_set.settings;
    const CoarseMesh& mesh = r.clusters.coarse();
    if (!settings.reduced || settings.light.wireframe || mesh.indices.empty() ||
        !r.photos.by_triangle(settings) || view.orthographic_depth > 0)
        return false;
    return mesh.error * view.intrinsics.fx <=
           max_pixels * nearness(r.scene, view, image_set.plan->in_view().opaque);
}

Eigen::Vector2d depth_terms(const View& view, const Eigen::Vector2d& range) {
    const Eigen::Matrix4d clip = clip_from_cam(view.intrinsics, range.x(), range.y());
    return {clip(2, 2), clip(2, 3)};
}

}  // namespace vantage
