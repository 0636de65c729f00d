#pragma once
#include <span>
#include <vector>

#include "base/gl/program.h"
#include "player/render/renderer.h"

namespace vantage {

/// A frame of one of several objects.
struct ObjectFrame {
    Renderer* renderer;
    const View& view;  ///< view last drawn by the renderer
    const RenderSettings& settings;
    double scale;    ///< scene units per unit of the object
    double opacity;  ///< 0 to 1
};

/// Composes the frames of several renderers into one picture: at each pixel, nearer objects cover those
/// behind them in proportion to their opacity; the background stays opaque. Use it only on the OpenGL thread.
class Composition {
  public:
    /// Shows the frames, which all have the size of `view`, in the framebuffer `target`, for the eye drawn
    /// last. `settings` specifies the background and whether to fill it.
    void show(std::span<const ObjectFrame> frames, const View& view, const RenderSettings& settings,
              const ShowTarget& target);

    /// Depth of the nearest object with an opacity above 0 at each pixel of the last frame shown: 32-bit
    /// values `near / z`, top row first, 0 beside the surfaces. `near` is in scene units; surfaces
    /// nearer than `near` have values above 1.
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
    std::vector<float> opacities_;  ///< opacities of the frame's objects
    gl::Framebuffer nearest_target_;
    gl::Program depth_program_, compose_program_, nearest_program_;
    gl::VertexArray no_vertices_;
};

}  // namespace vantage
