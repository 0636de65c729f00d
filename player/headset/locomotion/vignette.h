#pragma once
#include "base/gl/program.h"
#include "player/view/view.h"

namespace vantage {

/// Darkens the edges of what an eye sees: what moves there, while the body does not, makes people sick
/// (Fernandes and Feiner 2016). Belongs to the OpenGL thread.
class Vignette {
  public:
    /// Over the picture in the framebuffer `target`, whose first row is at the bottom. `strength`: 0 to 1.
    void draw(const View& view, GLuint target, double strength);

  private:
    gl::Program program_;
    gl::VertexArray no_vertices_;
};

}  // namespace vantage
