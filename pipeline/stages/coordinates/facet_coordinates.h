#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/visibility/photo_geometry.h"
#include "pipeline/visibility/photo_projection.h"

namespace vantage {

/// Like vertex_coordinates(), but for a stand-in (pipeline/mesh/stand_in.h): a vertex is visible if it is in
/// the frame and at most a facet's size behind the depth map of the cloud, because facets follow the points
/// only roughly. `indices`: three per facet of the stand-in.
std::vector<Eigen::Vector2f> facet_coordinates(const PhotoProjection& projection,
                                               std::span<const std::uint32_t> indices,
                                               const PhotoGeometry& maps, const Intrinsics& photo);

}  // namespace vantage
