#include "player/plan/triangle_corners.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

namespace vantage {

std::optional<Corners> corners_of(const PlanScene& scene, std::uint32_t triangle) {
    Corners out;
    for (std::size_t c = 0; c < 3; ++c) {
        const std::size_t at = 3 * std::size_t(triangle) + c;
        if (at >= scene.indices.size() || scene.indices[at] >= scene.positions.size()) return {};
        out[c] = scene.positions[scene.indices[at]].cast<double>();
    }
    return out;
}

double meets(const Ray& ray, const Corners& corner, double slack) {
    constexpr double misses = std::numeric_limits<double>::quiet_NaN();
    const Eigen::Vector3d a = corner[1] - corner[0], b = corner[2] - corner[0], across = ray.along.cross(b);
    const double volume = a.dot(across);
    if (!(std::abs(volume) > 1e-15 * ray.along.norm() * a.norm() * b.norm())) return misses;  // edge-on
    const Eigen::Vector3d from = ray.from - corner[0], other = from.cross(a);
    const double u = from.dot(across) / volume, v = ray.along.dot(other) / volume;
    if (!(u >= -slack && v >= -slack && u + v <= 1 + slack)) return misses;
    return b.dot(other) / volume;
}

}  // namespace vantage
