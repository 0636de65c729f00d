#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "scene/camera.h"

namespace vantage {

/// Positions on a map are in 1/2^14 of its pixels: finer than a single-precision texture coordinate, and maps
/// may be 65536 pixels wide.
inline constexpr int position_bits = 14;

/// A vertex on a photo's map. Nearer than the near plane, or too far aside for 32 bits: `inverse` is 0.
struct ProjectedVertex {
    std::int32_t x, y;
    float inverse;  ///< 1/z
};

/// The model as a photo's map sees it.
struct PhotoProjection {
    std::span<const Eigen::Vector3f> positions;
    Intrinsics intrinsics;  ///< of the map
    Pose cam_from_origin;
    float near;
    std::vector<ProjectedVertex> vertices;

    Eigen::Vector3d in_camera(std::uint32_t vertex) const {
        return cam_from_origin.R * positions[vertex].cast<double>() + cam_from_origin.t;
    }
};

PhotoProjection project_model(std::span<const Eigen::Vector3f> positions, const Intrinsics& map,
                              const Pose& cam_from_origin, double near);

/// A triangle, or a piece of one, of any size, wholly beyond the near plane.
struct ProjectedPiece {
    std::array<std::int64_t, 3> x, y;
    std::array<double, 3> inverse;

    /// What slivers lose in precision stays between their corners.
    double clamped(double plane) const;
};

/// What of a triangle is beyond the near plane.
struct ProjectedPieces {
    std::array<ProjectedPiece, 2> piece;
    int count = 0;
    auto begin() const { return piece.begin(); }
    auto end() const { return piece.begin() + count; }
};
ProjectedPieces clipped(const PhotoProjection& projection, const std::uint32_t* corners);

}  // namespace vantage
