#include "player/window/input/orbit_limit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "player/view/photo_directions.h"

namespace vantage {
namespace {

double angle_of(const Navigation& n, const PlanScene& scene) {
    return angle_from_photos(scene.photos, n.R.row(2).transpose());
}

/// Whether a part of the mesh is in the picture, apart from its margins.
bool shows_mesh(const View& view, const PlanScene& scene) {
    constexpr double inner = 0.8;
    const Intrinsics& k = view.intrinsics;
    return std::ranges::any_of(scene.clusters_of_mesh(), [&](const package::ClusterRecord& c) {
        const Eigen::Vector3d p =
            view.cam_from_origin.R * Eigen::Map<const Eigen::Vector3f>(c.center).cast<double>() +
            view.cam_from_origin.t;
        const double depth = view.orthographic_depth > 0 ? view.orthographic_depth : p.z();
        return p.z() > 0 && k.fx * std::abs(p.x()) < inner * depth * k.width / 2 &&
               k.fy * std::abs(p.y()) < inner * depth * k.height / 2;
    });
}

/// The fraction of a turn away from the photos that is made.
double yielding(double angle) {
    const double left = std::clamp(2 - angle / free_angle, 0.0, 1.0);
    return left * left;
}

}  // namespace

void orbit_near_photos(Session& s, const PlanScene& scene, const Eigen::Vector3d& pivot, double right,
                       double down) {
    Navigation& camera = s.viewpoint.camera;
    const Navigation before = camera;
    orbit_about(camera, pivot, right, down);
    if (!s.movement.near_photos) return;
    const double was = angle_of(before, scene), is = angle_of(camera, scene);
    if (is > free_angle && is > was) {
        camera = before;
        orbit_about(camera, pivot, right * yielding(is), down * yielding(is));
    }
    if (was <= free_angle) s.steering.inside = before;
    if (is <= free_angle) s.steering.inside.reset();
}

void return_to_photos(Session& s, double now) {
    if (s.steering.inside) start_flight(s.viewpoint, *s.steering.inside, now, 0.6);
    s.steering.inside.reset();
}

void pan_near_photos(Session& s, const PlanScene& scene, const View& view, const Eigen::Vector3d& by) {
    if (by.isZero()) return;
    Navigation& camera = s.viewpoint.camera;
    const Navigation before = camera;
    fly(camera, by);
    const View panned = shown_view(camera, s, scene, view.intrinsics.width, view.intrinsics.height);
    if (s.movement.near_photos && !shows_mesh(panned, scene) && shows_mesh(view, scene)) camera = before;
}

double farthest_distance(Session& s, const PlanScene& scene) {
    constexpr double farthest = 30, least_height = 0.2;
    if (s.movement.farthest) return *s.movement.farthest;
    if (!s.movement.near_photos) return farthest * scene.size;
    const double half_height = std::tan(s.viewpoint.camera.fov / 2 * std::numbers::pi / 180);
    const auto [low, high] = s.cut.extents.along(scene, s.viewpoint.camera.up);
    const double height = std::max(high - low, scene.size / 4);
    return std::min(farthest * scene.size, 0.5 * height / (least_height * std::max(half_height, 1e-3)));
}

}  // namespace vantage
