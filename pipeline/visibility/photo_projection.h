#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "scene/camera/camera.h"

namespace vantage {

/// Positions on a map are fixed-point, in 1/2^14 pixel: finer than a single-precision texture coordinate,
/// with enough range for maps 65536 pixels wide.
inline constexpr int position_bits = 14;

/// A vertex on a photo's map. `inverse` is 0 if the vertex is nearer than the near plane or its position
/// overflows 32 bits.
struct ProjectedVertex {
    std::int32_t x, y;
    float inverse;  ///< 1/z
};

/// The model projected into a photo's map. The owner of `positions` must outlive the projection.
struct PhotoProjection {
    std::span<const Eigen::Vector3f> positions;
    Intrinsics intrinsics;  ///< of the map
    Pose cam_from_origin;
    float near;  ///< near plane, scene units
    std::vector<ProjectedVertex> vertices;

    /// A vertex in camera space.
    Eigen::Vector3d in_camera(std::uint32_t vertex) const {
        return cam_from_origin.R * positions[vertex].cast<double>() + cam_from_origin.t;
    }
};

PhotoProjection project_model(std::span<const Eigen::Vector3f> positions, const Intrinsics& map,
                              const Pose& cam_from_origin, double near);

/// A triangle of any size, clipped against the near plane.
struct ProjectedPiece {
    std::array<std::int64_t, 3> x, y;
    std::array<double, 3> inverse;  ///< 1/z

    /// Inverse depth, clamped to the range of the corners, because interpolation loses precision on slivers.
    double clamped(double inverse_depth) const;
};

/// The part of a triangle beyond the near plane: up to two triangles.
struct ProjectedPieces {
    std::array<ProjectedPiece, 2> piece;
    int count = 0;
    auto begin() const { return piece.begin(); }
    auto end() const { return piece.begin() + count; }
};
/// `corners`: three vertex indices.
ProjectedPieces clipped(const PhotoProjection& projection, const std::uint32_t* corners);

}  // namespace vantage
