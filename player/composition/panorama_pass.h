#pragma once
#include <Eigen/Core>
#include <span>

#include "base/gl/object.h"
#include "base/gl/program.h"
#include "player/view/frame_size.h"

namespace vantage {

/// Pictures of parts of all directions: layers of a texture from `first` on, each with its middle ahead.
struct PanoramaFaces {
    GLuint pictures;
    int first;
    double focal;          ///< pixels
    Eigen::Vector2d half;  ///< what each shows alone, as tangents from its middle
    double overlap;        ///< with others, a tangent: there, one fades into the other
    std::span<const Eigen::Matrix3d> from_panorama;  ///< the axes of each, up to 6
};

/// Shows faces as a panorama. Belongs to the OpenGL thread.
class PanoramaPass {
  public:
    /// In the framebuffer `target`, which has this size, in `columns` columns from `first_column` on.
    void draw(const PanoramaFaces& faces, FrameSize size, int first_column, int columns, GLuint target);

  private:
    gl::Program program_;
    gl::VertexArray no_vertices_;
};

}  // namespace vantage
