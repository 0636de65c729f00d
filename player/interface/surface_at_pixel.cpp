#include "player/interface/surface_at_pixel.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "player/render/triangle_readback.h"

namespace vantage {
namespace {

/// The number of the triangle at a pixel, from 1; 0 for none.
std::uint32_t triangle_at(const SeenTriangles& seen, const Eigen::Vector2d& pixel) {
    const Intrinsics& k = seen.view.intrinsics;
    if (seen.triangles.empty() ||
        !(pixel.x() >= 0 && pixel.y() >= 0 && pixel.x() < k.width && pixel.y() < k.height))
        return 0;
    const std::size_t across = std::size_t(std::max(1, k.width / TriangleReadback::step)),
                      down = seen.triangles.size() / across;
    if (down == 0) return 0;
    const std::size_t x = std::min(across - 1, std::size_t(pixel.x() * double(across) / k.width)),
                      y = std::min(down - 1, std::size_t(pixel.y() * double(down) / k.height));
    return seen.triangles[y * across + x];
}

}  // namespace

std::optional<Eigen::Vector3d> surface_at_pixel(const PlanScene& scene, const SeenTriangles& seen,
                                                const Eigen::Vector2d& pixel) {
    const std::uint32_t triangle = triangle_at(seen, pixel);
    if (triangle == 0 || triangle > scene.triangles || 3 * std::size_t(triangle) > scene.indices.size())
        return {};
    std::array<Eigen::Vector3d, 3> corner;
    for (std::size_t c = 0; c < 3; ++c) {
        const std::uint32_t v = scene.indices[3 * std::size_t(triangle - 1) + c];
        if (v >= scene.positions.size()) return {};
        corner[c] = scene.positions[v].cast<double>();
    }
    const Intrinsics& k = seen.view.intrinsics;
    const Eigen::Vector3d eye = seen.view.cam_from_origin.center(),
                          ray = seen.view.cam_from_origin.R.transpose() *
                                Eigen::Vector3d((pixel.x() - k.cx) / k.fx, (pixel.y() - k.cy) / k.fy, 1),
                          normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
    const double along = ray.dot(normal), away = (corner[0] - eye).dot(normal) / along;
    if (!(std::abs(along) > 1e-9 * ray.norm() * normal.norm()) || !(away > 0)) return {};
    return eye + away * ray;
}

}  // namespace vantage
