#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <span>

#include "gl/object.h"
#include "gl/program.h"
#include "pipeline/visibility/photo_geometry.h"

namespace vantage {

/// The model's vertices on the graphics card, positions relative to the origin. Belongs to the OpenGL thread.
struct ModelBuffers {
    gl::Buffer positions, normals;
    gl::VertexArray vertices;
    gl::Program geometry;
    gl::Program jump_flood;  ///< empty where border distances are exact
};
ModelBuffers upload_model(std::span<const Eigen::Vector3f> positions,
                          std::span<const Eigen::Vector3f> normals);

/// Renders depth, angle and triangles. On the OpenGL thread. `indices` are the triangles that may reach into
/// the photo, see triangles_in_frame. Throws gl::Failure when OpenGL fails.
PhotoGeometry render_geometry(const ModelBuffers& model, std::span<const std::uint32_t> indices,
                              const Intrinsics& intrinsics, const Pose& cam_from_origin,
                              Eigen::Vector2d near_far);

}  // namespace vantage
