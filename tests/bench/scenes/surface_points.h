#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vantage::bench {

/// A place on a triangle: what each of its corners counts for, together 1. Single precision holds the weights
/// exactly.
struct SurfacePoint {
    std::size_t triangle;
    Eigen::Vector3d weights;
};

/// Random places, uniform by area, the same ones for the same seed; none where the triangles have no area.
std::vector<SurfacePoint> surface_points(std::span<const Eigen::Vector3f> positions,
                                         std::span<const std::uint32_t> indices, std::size_t count,
                                         unsigned seed);

/// The corners of a triangle, one a column.
Eigen::Matrix3d corners(std::span<const Eigen::Vector3f> positions, std::span<const std::uint32_t> indices,
                        std::size_t triangle);
/// Perpendicular to the triangle, counterclockwise corners facing its tip; its length is twice the area.
Eigen::Vector3d area_vector(const Eigen::Matrix3d& corners);

}  // namespace vantage::bench
