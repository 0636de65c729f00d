#pragma once
#include "base/gl/program.h"
#include "player/composition/object_set.h"

namespace vantage {

/// Enlarges frames that were drawn at a lower resolution, and shows unchanged frames again at little cost.
/// Use it only on the OpenGL thread.
class Enlargement {
  public:
    /// Allocates space for frames of at most this size, unless it has already been allocated.
    void fit(FrameSize size);
    /// Shows the last frame of `objects`, which was drawn for the view `drawn`. The framebuffer `target` has
    /// the size `size` and stays bound. If `drawn` is smaller than that, fit() must have been called for the
    /// size of `drawn`.
    void show(ObjectSet& objects, const View& drawn, const RenderSettings& settings, FrameSize size,
              const ShowTarget& target);
    /// Shows the last frame again. To be called only if nothing has changed since the last call of show() or
    /// show_again(). From the second call on, copies the picture if space has been allocated for it.
    void show_again(ObjectSet& objects, const View& drawn, const RenderSettings& settings, FrameSize size,
                    const ShowTarget& target);

  private:
    FrameSize allocated_;
    bool kept_ = false;  ///< picture_ holds the whole frame
    gl::Texture picture_;
    gl::Framebuffer target_;
    gl::Program program_;
    gl::VertexArray no_vertices_;
};

}  // namespace vantage
