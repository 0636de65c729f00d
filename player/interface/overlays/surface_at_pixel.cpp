#include "player/interface/overlays/surface_at_pixel.h"

#include <Eigen/Geometry>
#include <cmath>

#include "player/interface/overlays/seen_triangle.h"
#include "player/plan/triangle_corners.h"

namespace vantage {
std::optional<Eigen::Vector3d> surface_at_pixel(const PlanScene& scene, const SeenTriangles& seen,
                                                const Eigen::Vector2d& pixel) {
    const std::uint32_t triangle = seen_triangle(seen, pixel);
    if (triangle == 0 || triangle > scene.triangles) return {};
    const std::optional<Corners> corners = corners_of(scene, triangle - 1);
    if (!corners) return {};
    const Corners& corner = *corners;
    const Ray ray = ray_through(seen.view, pixel);
    const Eigen::Vector3d normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
    const double along = ray.along.dot(normal), away = (corner[0] - ray.from).dot(normal) / along;
    if (!(std::abs(along) > 1e-9 * normal.norm()) || !(away > 0)) return {};
    return ray.from + away * ray.along;
}

}  // namespace vantage
