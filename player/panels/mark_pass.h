#pragma once
#include "base/gl/program.h"
#include "player/panels/eye_picture.h"
#include "player/panels/growing_buffer.h"
#include "player/panels/marks.h"

namespace vantage {

/// Draws marks over pictures, with antialiased edges. Use it only on the OpenGL thread.
class MarkPass {
  public:
    MarkPass();

    /// Uploads the marks of a frame; draw() then draws them for each eye.
    void upload(const Marks& marks);
    /// Draws nothing for a view that is not finite.
    void draw(const EyePicture& eye);

  private:
    GrowingBuffer marks_{"marks"};
    std::vector<Marks::Run> runs_;
    gl::Program program_;
    gl::VertexArray vertices_;
};

}  // namespace vantage
