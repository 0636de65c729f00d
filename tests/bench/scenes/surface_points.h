#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vantage::bench {

/// A point on a triangle, given by its barycentric weights, which sum to 1 and are exact in single precision.
struct SurfacePoint {
    std::size_t triangle;
    Eigen::Vector3d weights;
};

/// Random points, distributed uniformly by area and reproducible from the seed; empty if the triangles have
/// no area.
std::vector<SurfacePoint> surface_points(std::span<const Eigen::Vector3f> positions,
                                         std::span<const std::uint32_t> indices, std::size_t count,
                                         unsigned seed);

/// The corners of a triangle, one per column.
Eigen::Matrix3d corners(std::span<const Eigen::Vector3f> positions, std::span<const std::uint32_t> indices,
                        std::size_t triangle);
/// The normal toward the side from which the corners appear counterclockwise; its length is twice the area.
Eigen::Vector3d area_vector(const Eigen::Matrix3d& corners);

}  // namespace vantage::bench
