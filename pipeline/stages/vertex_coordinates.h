#pragma once
#include <Eigen/Core>
#include <span>
#include <vector>

#include "pipeline/visibility/photo_projection.h"

namespace vantage {

/// A vertex: its texture coordinate in the photo, (-1,-1) where the photo does not see it (de Melo 2017,
/// 4.2): outside the frame, behind the camera, or behind a triangle by more than a third of a pixel's
/// footprint. Exact: every vertex is held against every triangle that its line of sight meets. `indices` are
/// the triangles that may reach into the photo, see triangles_in_frame.
std::vector<Eigen::Vector2f> vertex_coordinates(const PhotoProjection& projection,
                                                std::span<const std::uint32_t> indices,
                                                const Intrinsics& photo);

}  // namespace vantage
