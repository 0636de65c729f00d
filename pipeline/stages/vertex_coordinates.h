#pragma once
#include <span>
#include <vector>

#include "pipeline/stages/rasterise.h"

namespace vantage {

/// A vertex: its texture coordinate in the photo, (-1,-1) where the photo does not see it,
/// `unsettled_coordinate` where the triangles that the pixels around it see do not settle that. The same as
/// texture_coordinates.vert finds, from the map of triangles in `geometry`.
std::vector<Eigen::Vector2f> vertex_coordinates(const ModelSpans& model,
                                                std::span<const std::uint32_t> indices,
                                                const Intrinsics& intrinsics, const Pose& cam_from_origin,
                                                const PhotoGeometry& geometry);

}  // namespace vantage
