#pragma once
#include <span>
#include <vector>

#include "gl/program.h"
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
/// them, which show through by what the nearer one's opacity leaves; surroundings stay opaque. Belongs to the
/// OpenGL thread.
class Composition {
  public:
    /// Shows the frames, all of the size of `view`, in the framebuffer `target`; `flip` as for
    /// Renderer::show. `settings`: background, and whether it is filled. `eye`: the one drawn last.
    void show(std::span<const ObjectFrame> frames, const View& view, const RenderSettings& settings,
              GLuint target, bool flip, std::size_t eye);

  private:
    struct Layer {
        gl::Framebuffer color, depth;
    };
    void fit(FrameSize room, std::size_t objects);
    void copy_depth(const ObjectFrame& frame, const Layer& layer);

    FrameSize room_, frame_;
    gl::Texture colors_, depths_;
    std::vector<Layer> layers_;
    gl::Program depth_program_, compose_program_;
    gl::VertexArray no_vertices_;
};

}  // namespace vantage
