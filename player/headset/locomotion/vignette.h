#pragma once
#include "base/gl/program.h"
#include "player/view/view.h"

namespace vantage {

/// Darkens the edges of an eye's picture: visual motion without body motion causes sickness (Fernandes and
/// Feiner 2016). Use it only on the OpenGL thread.
class Vignette {
  public:
    /// Draws over the picture in the framebuffer `target`, with the bottom row first. `strength`: 0 to 1.
    void draw(const View& view, GLuint target, double strength);

  private:
    gl::Program program_;
    gl::VertexArray no_vertices_;
};

}  // namespace vantage
