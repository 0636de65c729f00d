#include "player/survey/ray_cast.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "player/plan/triangle_corners.h"

namespace vantage {
namespace {

constexpr double on_edge = 1e-12;  ///< barycentric tolerance, so that rays do not pass between triangles

/// Whether the ray enters a box within `range`.
bool enters(const Ray& ray, const Eigen::Vector3d& low, const Eigen::Vector3d& high, RayRange range) {
    for (int axis = 0; axis < 3; ++axis) {
        if (ray.along[axis] == 0) {
            if (!(ray.from[axis] >= low[axis] && ray.from[axis] <= high[axis])) return false;
            continue;
        }
        const double a = (low[axis] - ray.from[axis]) / ray.along[axis],
                     b = (high[axis] - ray.from[axis]) / ray.along[axis];
        range.nearest = std::max(range.nearest, std::min(a, b));
        range.farthest = std::min(range.farthest, std::max(a, b));
    }
    return range.nearest <= range.farthest * (1 + 1e-12) || range.nearest <= range.farthest + 1e-12;
}

/// Whether a ray intersects the cluster's bounding sphere.
bool passes(const Ray& ray, const package::ClusterRecord& c) {
    const Eigen::Vector3d to = Eigen::Vector3d(c.center[0], c.center[1], c.center[2]) - ray.from;
    const double length2 = ray.along.squaredNorm();
    const Eigen::Vector3d off = to - ray.along * (to.dot(ray.along) / length2);
    const double reach = double(c.radius) * (1 + 1e-5) + 1e-12 * to.norm();
    return !(off.squaredNorm() > reach * reach);
}

void look_in_cluster(const PlanScene& scene, const package::ClusterRecord& cluster, const Ray& ray,
                     RayRange& range, std::optional<MeshHit>& nearest) {
    for (std::uint32_t i = 0; i < cluster.triangles; ++i) {
        const std::uint32_t triangle = cluster.first_triangle + i;
        const auto corner = corners_of(scene, triangle);
        if (!corner) return;
        const double distance = meets(ray, *corner, on_edge);
        if (!(distance >= range.nearest && distance <= range.farthest)) continue;
        nearest = MeshHit{triangle, distance, ray.from + ray.along * distance};
        range.farthest = distance;
    }
}

}  // namespace

std::optional<MeshHit> first_hit(const PlanScene& scene, const Ray& ray, RayRange range) {
    if (!ray.from.allFinite() || !ray.along.allFinite() || !(ray.along.squaredNorm() > 0)) return {};
    std::optional<MeshHit> nearest;
    const auto& nodes = scene.tree.nodes;
    for (std::size_t i = 0; i < nodes.size();) {
        const ClusterTree::Node& node = nodes[i];
        if (node.first >= scene.first_surrounding || !enters(ray, node.low, node.high, range)) {
            i = node.next;
            continue;
        }
        const bool leaf = node.next == i + 1;
        const std::uint32_t end = std::min(node.first + node.count, scene.first_surrounding);
        for (std::uint32_t c = node.first; leaf && c < end; ++c)
            if (passes(ray, scene.clusters[c]))
                look_in_cluster(scene, scene.clusters[c], ray, range, nearest);
        ++i;
    }
    return nearest;
}

}  // namespace vantage
