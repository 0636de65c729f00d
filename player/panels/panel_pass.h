#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "base/gl/program.h"
#include "player/panels/distance_field_font.h"
#include "player/panels/eye_picture.h"
#include "player/panels/growing_buffer.h"
#include "player/panels/panel.h"

struct ImDrawData;
struct ImDrawList;

namespace vantage {

/// All draw lists of ImGui.
std::span<ImDrawList* const> lists_of(const ImDrawData& drawn);

/// ImGui's draw data for a panel, in graphics memory: uploaded once per frame, drawn for each eye. Belongs to
/// the OpenGL thread.
class PanelDrawing {
  public:
    /// Replaces the uploaded data. Callbacks among the commands are ignored.
    void upload(std::span<ImDrawList* const> lists);

  private:
    friend class PanelPass;
    struct Command {
        Eigen::Vector4f clip;  ///< left, top, right, bottom: panel pixels
        GLuint texture;
        GLsizei indices;
        std::size_t first_index;
        GLint first_vertex;
    };
    GrowingBuffer vertices_{"panel vertices"}, indices_{"panel indices"};
    std::vector<Command> commands_;
};

/// Draws panels over pictures, directly at the picture's resolution: the edges of text are one pixel wide at
/// any distance and angle. ImGui's textures must be names of two-dimensional OpenGL textures with sRGB bytes,
/// sampled without decoding. Use it only on the OpenGL thread.
class PanelPass {
  public:
    explicit PanelPass(const DistanceField& font);

    /// The texture to set in the atlas that the field was built from.
    GLuint font() const { return field_.id(); }
    /// Draws a panel over an eye's picture, or nothing if the panel or the view is not finite.
    void draw(const PanelDrawing& drawing, const Panel& panel, const EyePicture& eye);

  private:
    gl::Texture field_, letters_;
    float spread_;
    gl::Program program_;
    gl::VertexArray vertices_;
};

}  // namespace vantage
