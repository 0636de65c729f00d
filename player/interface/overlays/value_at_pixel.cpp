#include "player/interface/overlays/value_at_pixel.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "player/survey/ray_cast.h"

namespace vantage {

std::optional<double> value_at_pixel(const PlanScene& scene, std::span<const float> values,
                                     std::uint32_t triangle, const View& view, const Eigen::Vector2d& pixel) {
    if (triangle >= scene.triangles) return {};
    std::array<Eigen::Vector3d, 3> corner;
    Eigen::Vector3d value;
    for (int c = 0; c < 3; ++c) {
        const std::uint32_t v = scene.indices[3 * std::size_t(triangle) + std::size_t(c)];
        if (v >= values.size() || !std::isfinite(values[v])) return {};  // the background has no values
        corner[std::size_t(c)] = scene.positions[v].cast<double>();
        value[c] = double(values[v]);
    }
    const Ray ray = ray_through(view, pixel);
    const Eigen::Vector3d a = corner[1] - corner[0], b = corner[2] - corner[0], across = ray.along.cross(b);
    const double volume = a.dot(across);
    if (std::abs(volume) <= 1e-12 * a.norm() * b.norm()) return {};
    // Moeller and Trumbore 1997.
    const Eigen::Vector3d from = ray.from - corner[0];
    const double u = from.dot(across) / volume, v = ray.along.dot(from.cross(a)) / volume;
    const Eigen::Vector3d share = Eigen::Vector3d(1 - u - v, u, v).cwiseMax(0);
    return share.dot(value) / share.sum();
}

}  // namespace vantage
