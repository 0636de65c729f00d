#include "pipeline/background/backdrop.h"

#include <algorithm>
#include <cmath>

#include "pipeline/background/depth/depth_smoothing.h"
#include "pipeline/background/depth/refine_depths.h"
#include "pipeline/background/depth/walls_beyond.h"
#include "pipeline/background/view_sample.h"

namespace vantage {
namespace {

/// A rotation to axes derived from the cameras, so that the world's axes do not matter.
Eigen::Matrix3f frame_of(std::span<const CoarseView> views) {
    const Eigen::Vector3d down = down_direction(views);
    Eigen::Vector3d forward = Eigen::Vector3d::Zero();
    for (const CoarseView& v : views) forward += v.pose.direction();
    forward -= forward.dot(down) * down;
    if (forward.norm() < 1e-3 * double(views.size())) forward = views[0].pose.R.row(0).transpose();
    const Eigen::Vector3d right = down.cross(forward).normalized();
    Eigen::Matrix3f out;
    out << right.cast<float>(), down.cross(right).cast<float>(), down.cast<float>();
    return out;
}

/// Moves the directions of the sky to infinity.
void move_sky_away(Backdrop& backdrop, std::span<const CoarseView> views, const SweptDepths& depths,
                   std::vector<float>& inverse, unsigned threads) {
    backdrop.is_sky = sky_directions(views, backdrop.sky, backdrop.sphere, threads);
    const std::vector<float> base = base_depths(backdrop.sphere, depths.center, depths.reach, {});
    for (std::size_t v = 0; v < backdrop.is_sky.size(); ++v)
        if (backdrop.is_sky[v]) inverse[v] = base[v];
}

}  // namespace

bool have_parallax(std::span<const CoarseView> views) {
    double farthest = 0, size = 0;
    for (const CoarseView& v : views) {
        farthest = std::max(farthest, (v.pose.center() - views[0].pose.center()).norm());
        size = std::max(size, v.pose.center().norm());
    }
    return views.size() > 1 && farthest > 1e-6 * size;
}

Backdrop estimate_backdrop(std::span<const CoarseView> views, const MeshPlanes& mesh,
                           const BackdropDetail& detail, unsigned threads) {
    Backdrop out{
        .sphere = direction_sphere(detail.sphere), .center = {}, .positions = {}, .sky = {}, .is_sky = {}};
    const Eigen::Matrix3f frame = frame_of(views);
    for (Eigen::Vector3f& d : out.sphere.directions) d = (frame * d).normalized();
    ScenePlanes planes{find_ground(views, mesh), mesh.largest};
    SweptDepths depths = sweep_depths(views, out.sphere, planes, detail.labels, threads);
    out.center = depths.center;
    std::vector<float> inverse = inverse_distances(depths, out.sphere);
    const Eigen::Vector3d down = down_direction(views, mesh);
    const std::vector<Plane> beyond = walls_beyond(depths, out.sphere, inverse, down);
    if (!beyond.empty()) {
        prefer_planes(depths, views, out.sphere, beyond, threads);
        planes.walls.insert(planes.walls.end(), beyond.begin(), beyond.end());
        inverse = inverse_distances(depths, out.sphere);
    }
    out.sky.down = down.cast<float>();
    if (detail.sky) out.sky = find_sky(views, depths, out.sphere, inverse, down);
    move_sky_away(out, views, depths, inverse, threads);
    for (int l = 0; l < detail.refinements; ++l) {
        DirectionSphere fine = divided(out.sphere);
        inverse = refine_depths(views, planes, depths, inverse, fine, threads);
        out.sphere = std::move(fine);
    }
    move_sky_away(out, views, depths, inverse, threads);
    for (std::size_t v = 0; v < inverse.size(); ++v)
        out.positions.push_back(
            (out.center + out.sphere.directions[v].cast<double>() / double(inverse[v])).cast<float>());
    return out;
}

}  // namespace vantage
