#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/visibility/photo_projection.h"

namespace vantage {

/// Texture coordinates in the photo, one per vertex; (-1, -1) if the photo does not see the vertex [M, 4.2]:
/// it is outside the frame, behind the camera, or occluded by a triangle nearer by more than about a third of
/// a pixel's footprint. Occlusion is tested against every triangle on the line of sight, not against a depth
/// map. `indices`: three per triangle that may reach into the photo, see triangles_in_frame. `tests`, if not
/// null, is set to the number of tests for triangles that are at most 62 map pixels wide and high; each test
/// compares a triangle with `lanes` vertices or blocks of vertices.
std::vector<Eigen::Vector2f> vertex_coordinates(const PhotoProjection& projection,
                                                std::span<const std::uint32_t> indices,
                                                const Intrinsics& photo, std::uint64_t* tests = nullptr);

}  // namespace vantage
