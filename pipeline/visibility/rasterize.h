#pragma once
#include <Eigen/Core>
#include <span>

#include "pipeline/visibility/photo_geometry.h"
#include "pipeline/visibility/photo_projection.h"

namespace vantage {

/// What render_geometry gives, by the processor alone: for machines whose OpenGL is the processor, too, where
/// it is several times as fast (see triangle_map.h). Normals are of unit length; indices as of
/// render_geometry.
PhotoGeometry rasterize_geometry(const PhotoProjection& projection, std::span<const Eigen::Vector3f> normals,
                                 std::span<const std::uint32_t> indices);

}  // namespace vantage
