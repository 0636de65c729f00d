#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <span>

#include "base/gl/object.h"
#include "base/gl/program.h"
#include "pipeline/visibility/photo_geometry.h"

namespace vantage {

/// The model's vertices and the programs that draw them. Positions are relative to the origin. For use on the
/// OpenGL thread only.
struct ModelBuffers {
    gl::Buffer positions, normals;
    gl::VertexArray vertices;
    gl::Program geometry;
    gl::Program jump_flood;  ///< empty if border distances are exact
};
ModelBuffers upload_model(std::span<const Eigen::Vector3f> positions,
                          std::span<const Eigen::Vector3f> normals);

/// Renders the depth, angle and triangle maps. Must be called on the OpenGL thread. `indices`: three per
/// triangle, see triangles_in_frame. `near_far`: clip planes, see depth_range. Throws gl::Failure on OpenGL
/// errors.
PhotoGeometry render_geometry(const ModelBuffers& model, std::span<const std::uint32_t> indices,
                              const Intrinsics& intrinsics, const Pose& cam_from_origin,
                              Eigen::Vector2d near_far);

}  // namespace vantage
