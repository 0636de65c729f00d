#pragma once
#include "base/gl/program.h"
#include "player/composition/object_set.h"
#include "player/headset/runtime/headset_session.h"

namespace vantage {

/// Provides the headset with depth values, so that it can reproject late frames to the current head pose.
/// Use it only on the OpenGL thread.
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
