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

/// All that ImGui drew.
std::span<ImDrawList* const> lists_of(const ImDrawData& drawn);

/// What ImGui drew for a panel, in graphics memory: uploaded once per frame, drawn for each eye. Belongs to
/// the OpenGL thread.
class PanelDrawing {
  public:
    /// Replaces what was uploaded. Callbacks among the commands are ignored.
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

/// Draws panels over pictures, straight at the picture's pixels: text keeps edges of one pixel at any
/// distance and angle. ImGui's textures are names of two-dimensional OpenGL textures with sRGB bytes that are
/// not decoded. Belongs to the OpenGL thread.
class PanelPass {
  public:
    explicit PanelPass(const DistanceField& font);

    /// To be set as the texture of the atlas that the field was built from.
    GLuint font() const { return field_.id(); }
    /// Draws a panel over an eye's picture; nothing for a panel or a view that is not finite.
    void draw(const PanelDrawing& drawing, const Panel& panel, const EyePicture& eye);

  private:
    gl::Texture field_, letters_;
    float spread_;
    gl::Program program_;
    gl::VertexArray vertices_;
};

}  // namespace vantage
