#pragma once
#include <Eigen/Core>
#include <span>

#include "base/gl/object.h"
#include "base/gl/program.h"
#include "player/view/frame_size.h"

namespace vantage {

/// Pictures of parts of the sphere: layers of a texture from `first` on, each with its viewing direction at
/// the center.
struct PanoramaFaces {
    GLuint pictures;
    int first;
    double focal;          ///< pixels
    Eigen::Vector2d half;  ///< extent that only this face covers, as tangents from its center
    double overlap;        ///< width of the cross-fade between faces, as a tangent
    std::span<const Eigen::Matrix3d> from_panorama;  ///< rotations to the axes of the faces, at most 6
};

/// Shows faces as a panorama. Use it only on the OpenGL thread.
class PanoramaPass {
  public:
    /// Draws into the framebuffer `target` of this size, in `columns` columns from `first_column` on.
    void draw(const PanoramaFaces& faces, FrameSize size, int first_column, int columns, GLuint target);

  private:
    gl::Program program_;
    gl::VertexArray no_vertices_;
};

}  // namespace vantage
