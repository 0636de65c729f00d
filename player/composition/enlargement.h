#pragma once
#include "base/gl/program.h"
#include "player/composition/object_set.h"

namespace vantage {

/// Shows frames that were drawn smaller at their full size, and frames that stay at little cost. Belongs to
/// the OpenGL thread.
class Enlargement {
  public:
    /// Makes room for frames of at most this size, unless there is.
    void fit(FrameSize size);
    /// Shows what `objects` drew last, of the view `drawn`, in the framebuffer `target` of this size, which
    /// stays bound. fit() must have made room for `drawn` if it is smaller.
    void show(ObjectSet& objects, const View& drawn, const RenderSettings& settings, FrameSize size,
              const ShowTarget& target);
    /// The same where nothing has changed since show(): from the second time on, copies the picture, if
    /// there is room for it.
    void show_again(ObjectSet& objects, const View& drawn, const RenderSettings& settings, FrameSize size,
                    const ShowTarget& target);

  private:
    FrameSize allocated_;
    bool kept_ = false;  ///< picture_ is the whole frame
    gl::Texture picture_;
    gl::Framebuffer target_;
    gl::Program program_;
    gl::VertexArray no_vertices_;
};

}  // namespace vantage
