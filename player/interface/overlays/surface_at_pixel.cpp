#include "player/interface/overlays/surface_at_pixel.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "player/interface/overlays/seen_triangle.h"
#include "player/survey/ray_cast.h"

namespace vantage {
std::optional<Eigen::Vector3d> surface_at_pixel(const PlanScene& scene, const SeenTriangles& seen,
                                                const Eigen::Vector2d& pixel) {
    const std::uint32_t triangle = seen_triangle(seen, pixel);
    if (triangle == 0 || triangle > scene.triangles || 3 * std::size_t(triangle) > scene.indices.size())
        return {};
    std::array<Eigen::Vector3d, 3> corner;
    for (std::size_t c = 0; c < 3; ++c) {
        const std::uint32_t v = scene.indices[3 * std::size_t(triangle - 1) + c];
        if (v >= scene.positions.size()) return {};
        corner[c] = scene.positions[v].cast<double>();
    }
    const Ray ray = ray_through(seen.view, pixel);
    const Eigen::Vector3d normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
    const double along = ray.along.dot(normal), away = (corner[0] - ray.from).dot(normal) / along;
    if (!(std::abs(along) > 1e-9 * normal.norm()) || !(away > 0)) return {};
    return ray.from + away * ray.along;
}

}  // namespace vantage
