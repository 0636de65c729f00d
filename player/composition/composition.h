#pragma once
#include <span>
#include <vector>

#include "base/gl/program.h"
#include "player/render/renderer.h"

namespace vantage {

/// A frame of one of several objects.
struct ObjectFrame {
    Renderer* renderer;
    const View& view;  ///< that the renderer drew last
    const RenderSettings& settings;
    double scale;    ///< of the object in the scene
    double opacity;  ///< 0 to 1
};

/// Composes what several renderers drew into one picture: at each pixel, nearer objects over those behind
/// them, which show through by what the nearer one's opacity leaves; background stays opaque. Belongs to the
/// OpenGL thread.
class Composition {
  public:
    /// Shows the frames, all of the size of `view`, in the framebuffer `target`, whose eye is
    /// the one drawn last. `settings`: background, and whether it is filled.
    void show(std::span<const ObjectFrame> frames, const View& view, const RenderSettings& settings,
              const ShowTarget& target);

    /// How near the nearest object whose opacity is above 0 is at each pixel of the frame that was shown
    /// last: 32-bit depths `near / z` from the first texel on, top row first, 0 where there is none. `near`
    /// in the scene's unit; depths of what is nearer are above 1.
    const gl::Texture& nearest_depth(double near);

  private:
    struct Layer {
        gl::Framebuffer color, depth;
    };
    void fit(FrameSize size, std::size_t objects);
    void copy_depth(const ObjectFrame& frame, const Layer& layer);

    FrameSize allocated_, frame_;
    gl::Texture colors_, depths_, nearest_;
    std::vector<Layer> layers_;
    std::vector<float> opacities_;  ///< of the objects in the frame
    gl::Framebuffer nearest_target_;
    gl::Program depth_program_, compose_program_, nearest_program_;
    gl::VertexArray no_vertices_;
};

}  // namespace vantage
