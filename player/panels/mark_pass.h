#pragma once
#include "base/gl/program.h"
#include "player/panels/eye_picture.h"
#include "player/panels/growing_buffer.h"
#include "player/panels/marks.h"

namespace vantage {

/// Draws marks over pictures, with smooth edges. Belongs to the OpenGL thread.
class MarkPass {
  public:
    MarkPass();

    /// Takes the marks of a frame, which draw() then draws for each eye.
    void upload(const Marks& marks);
    /// Nothing for a view that is not finite.
    void draw(const EyePicture& eye);

  private:
    GrowingBuffer marks_{"marks"};
    std::vector<Marks::Run> runs_;
    gl::Program program_;
    gl::VertexArray vertices_;
};

}  // namespace vantage
