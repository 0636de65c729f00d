#pragma once
#include <Eigen/Core>
#include <span>

#include "pipeline/visibility/photo_geometry.h"
#include "pipeline/visibility/photo_projection.h"

namespace vantage {

/// The maps of render_geometry, computed on the CPU; several times faster than software OpenGL. `normals` are
/// unit vectors, one per vertex; `indices` are as in render_geometry.
PhotoGeometry rasterize_geometry(const PhotoProjection& projection, std::span<const Eigen::Vector3f> normals,
                                 std::span<const std::uint32_t> indices);

}  // namespace vantage
