#include "tests/bench/scenes/surface_points.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <random>

namespace vantage::bench {

Eigen::Matrix3d corners(std::span<const Eigen::Vector3f> positions, std::span<const std::uint32_t> indices,
                        std::size_t triangle) {
    Eigen::Matrix3d c;
    for (int i = 0; i < 3; ++i) c.col(i) = positions[indices[3 * triangle + std::size_t(i)]].cast<double>();
    return c;
}

Eigen::Vector3d area_vector(const Eigen::Matrix3d& c) {
    return (c.col(1) - c.col(0)).cross(c.col(2) - c.col(0));
}

std::vector<SurfacePoint> surface_points(std::span<const Eigen::Vector3f> positions,
                                         std::span<const std::uint32_t> indices, std::size_t count,
                                         unsigned seed) {
    std::vector<double> area_up_to;
    double area = 0;
    for (std::size_t t = 0; t < indices.size() / 3; ++t) {
        area += area_vector(corners(positions, indices, t)).norm();
        area_up_to.push_back(area);
    }
    std::vector<SurfacePoint> out;
    if (!(area > 0)) return out;
    std::mt19937 engine(seed);
    while (out.size() < count) {
        const double at = double(engine()) * 0x1p-32 * area;
        const auto t = std::upper_bound(area_up_to.begin(), area_up_to.end(), at) - area_up_to.begin();
        // u and v have twenty bits each, so that 1 - u - v is also exact; points beyond the diagonal are
        // mirrored.
        double u = double(engine() >> 12) * 0x1p-20, v = double(engine() >> 12) * 0x1p-20;
        if (u + v > 1) u = 1 - u, v = 1 - v;
        out.push_back({std::min(std::size_t(t), area_up_to.size() - 1), {1 - u - v, u, v}});
    }
    return out;
}

}  // namespace vantage::bench
