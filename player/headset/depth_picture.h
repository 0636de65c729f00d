#pragma once
#include "gl/program.h"
#include "player/headset/headset_session.h"
#include "player/objects/object_set.h"

namespace vantage {

/// Tells a headset how far away what it shows is, so that it can show frames that are late from where the
/// head is by then. Belongs to the OpenGL thread.
class DepthPicture {
  public:
    /// Copies the depth of a frame of this size into the framebuffer `target`. `scale`: scene units per
    /// meter.
    DepthLimits copy(const DrawnDepth& depth, FrameSize size, double scale, GLuint target);

  private:
    gl::Program program_;
    gl::VertexArray no_vertices_;
};

}  // namespace vantage
