#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "gl/object.h"
#include "scene/camera.h"

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

/// What a photo's camera sees of the model.
struct PhotoGeometry {
    int width = 0, height = 0;             ///< of the maps: the photo's at `mask_level`
    std::vector<float> z;                  ///< linear depth, +inf where nothing is seen
    std::vector<std::uint8_t> angle;       ///< max(0, n.v), unorm8
    std::vector<std::uint32_t> triangles;  ///< which of the triangles given; none: 2^32 - 1
};

/// The intrinsics of a photo's maps.
Intrinsics map_intrinsics(const Intrinsics& photo);

/// Near and far plane that hold the model, by its vertices' depths, see clip_range.
Eigen::Vector2d depth_range(std::span<const Eigen::Vector3f> positions, const Pose& cam_from_origin);

/// Renders depth, angle and triangles. On the OpenGL thread. `indices` are the triangles that may reach into
/// the photo, see triangles_in_frame. Throws gl::Failure when OpenGL fails.
PhotoGeometry render_geometry(const ModelBuffers& model, std::span<const std::uint32_t> indices,
                              const Intrinsics& intrinsics, const Pose& cam_from_origin,
                              Eigen::Vector2d near_far);

}  // namespace vantage
