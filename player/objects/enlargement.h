#pragma once
#include "gl/program.h"
#include "player/objects/object_set.h"

namespace vantage {

/// Shows frames that were drawn smaller at their full size. Belongs to the OpenGL thread.
class Enlargement {
  public:
    /// Makes room for frames of at most this size, unless there is.
    void fit(FrameSize room);
    /// Shows what `objects` drew last, of the view `drawn`, in the framebuffer `target` of this size;
    /// `flip` as for Renderer::show. fit() must have made room for `drawn` if it is smaller.
    void show(ObjectSet& objects, const View& drawn, const RenderSettings& settings, FrameSize size,
              GLuint target, bool flip);

  private:
    FrameSize room_;
    gl::Texture picture_;
    gl::Framebuffer target_;
    gl::Program program_;
    gl::VertexArray no_vertices_;
};

}  // namespace vantage
