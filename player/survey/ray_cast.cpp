#include "player/survey/ray_cast.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

namespace vantage {
namespace {

constexpr double on_edge = 1e-12;  ///< barycentric: a ray through an edge meets one of its triangles

using Corners = std::array<Eigen::Vector3d, 3>;

/// Nothing if the file was overwritten and an index is out of range.
std::optional<Corners> corners_of(const PlanScene& scene, std::uint32_t triangle) {
    Corners out;
    for (std::size_t c = 0; c < 3; ++c) {
        const std::size_t at = 3 * std::size_t(triangle) + c;
        if (at >= scene.indices.size() || scene.indices[at] >= scene.positions.size()) return {};
        out[c] = scene.positions[scene.indices[at]].cast<double>();
    }
    return out;
}

/// The distance at which a ray meets a triangle; NaN if it does not.
double meets(const Ray& ray, const Corners& corner) {
    constexpr double misses = std::numeric_limits<double>::quiet_NaN();
    const Eigen::Vector3d a = corner[1] - corner[0], b = corner[2] - corner[0], across = ray.along.cross(b);
    const double volume = a.dot(across);
    if (!(std::abs(volume) > 1e-15 * ray.along.norm() * a.norm() * b.norm())) return misses;  // edge-on
    const Eigen::Vector3d from = ray.from - corner[0], other = from.cross(a);
    const double u = from.dot(across) / volume, v = ray.along.dot(other) / volume;
    if (!(u >= -on_edge && v >= -on_edge && u + v <= 1 + on_edge)) return misses;
    return b.dot(other) / volume;
}

/// Whether the ray enters a box before `range` ends.
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

/// Whether a ray comes near enough to the cluster's bounding sphere.
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
        const double distance = meets(ray, *corner);
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
