#include "player/panels/panel_pass.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "base/gl/context.h"
#include "shaders/contract.h"

namespace vantage {
namespace {

// Maximum mipmap level, at which glyphs in the atlas are one texel apart.
constexpr int letter_levels = 4;

template <class T>
std::span<const std::byte> bytes_of(const ImVector<T>& v) {
    return std::as_bytes(std::span(v.Data, std::size_t(v.Size)));
}

gl::Texture upload_field(const DistanceField& font) {
    gl::Texture out = gl::make_texture_2d("distances to letters", GL_R16, font.width, font.height, GL_LINEAR);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 2);
    glTextureSubImage2D(out.id(), 0, 0, 0, font.width, font.height, GL_RED, GL_UNSIGNED_SHORT,
                        font.distances.data());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    return out;
}

gl::Texture upload_letters(const DistanceField& font) {
    GLuint id = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &id);
    gl::Texture out(id);
    glObjectLabel(GL_TEXTURE, id, -1, "small letters");
    glTextureStorage2D(id, letter_levels, GL_R8, font.width, font.height);
    glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTextureParameteri(id, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTextureParameteri(id, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(id, 0, 0, 0, font.width, font.height, GL_RED, GL_UNSIGNED_BYTE, font.coverage.data());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glGenerateTextureMipmap(id);
    return out;
}

gl::VertexArray panel_vertices() {
    gl::VertexArray out = gl::make_vertex_array("panel");
    const GLuint id = out.id();
    glVertexArrayAttribFormat(id, shader::position_attribute, 2, GL_FLOAT, GL_FALSE,
                              offsetof(ImDrawVert, pos));
    glVertexArrayAttribFormat(id, shader::texture_attribute, 2, GL_FLOAT, GL_FALSE, offsetof(ImDrawVert, uv));
    glVertexArrayAttribFormat(id, shader::color_attribute, 4, GL_UNSIGNED_BYTE, GL_TRUE,
                              offsetof(ImDrawVert, col));
    for (const int attribute :
         {shader::position_attribute, shader::texture_attribute, shader::color_attribute}) {
        glVertexArrayAttribBinding(id, GLuint(attribute), 0);
        glEnableVertexArrayAttrib(id, GLuint(attribute));
    }
    return out;
}

}  // namespace

std::span<ImDrawList* const> lists_of(const ImDrawData& drawn) {
    // CmdLists is a pointer or, in newer versions of ImGui, a vector.
    return drawn.CmdListsCount > 0 ? std::span(&drawn.CmdLists[0], std::size_t(drawn.CmdListsCount))
                                   : std::span<ImDrawList* const>();
}

void PanelDrawing::upload(std::span<ImDrawList* const> lists) {
    commands_.clear();
    std::size_t vertices = 0, indices = 0;
    for (const ImDrawList* list : lists) {
        vertices += std::size_t(list->VtxBuffer.Size);
        indices += std::size_t(list->IdxBuffer.Size);
    }
    vertices_.begin(vertices * sizeof(ImDrawVert));
    indices_.begin(indices * sizeof(ImDrawIdx));
    vertices = indices = 0;
    for (const ImDrawList* list : lists) {
        vertices_.write(bytes_of(list->VtxBuffer));
        indices_.write(bytes_of(list->IdxBuffer));
        for (const ImDrawCmd& c : list->CmdBuffer)
            if (!c.UserCallback && c.ElemCount > 0)
                commands_.push_back({{c.ClipRect.x, c.ClipRect.y, c.ClipRect.z, c.ClipRect.w},
                                     GLuint(std::uintptr_t(c.GetTexID())),
                                     GLsizei(c.ElemCount),
                                     indices + c.IdxOffset,
                                     GLint(vertices + c.VtxOffset)});
        vertices += std::size_t(list->VtxBuffer.Size);
        indices += std::size_t(list->IdxBuffer.Size);
    }
}

PanelPass::PanelPass(const DistanceField& font)
    : field_(upload_field(font)),
      letters_(upload_letters(font)),
      spread_(font.spread),
      program_(
          gl::make_program("panel", {{GL_VERTEX_SHADER, "panel.vert"}, {GL_FRAGMENT_SHADER, "panel.frag"}})),
      vertices_(panel_vertices()) {}

void PanelPass::draw(const PanelDrawing& drawing, const Panel& panel, const EyePicture& eye) {
    const Eigen::Matrix4f clip = (clip_from_origin(eye) * origin_from_panel(panel)).cast<float>();
    if (!clip.allFinite() || drawing.commands_.empty()) return;
    begin_over_picture(program_, eye);
    glUniformMatrix4fv(shader::clip_from_origin_uniform, 1, GL_FALSE, clip.data());
    glUniform1f(shader::spread_uniform, spread_);
    glBindTextureUnit(shader::field_unit, field_.id());
    glBindTextureUnit(shader::letters_unit, letters_.id());
    glVertexArrayVertexBuffer(vertices_.id(), 0, drawing.vertices_.id(), 0, sizeof(ImDrawVert));
    glVertexArrayElementBuffer(vertices_.id(), drawing.indices_.id());
    glBindVertexArray(vertices_.id());
    constexpr GLenum index_type = sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT;
    const Eigen::Vector4f whole(0, 0, float(panel.width), float(panel.height));
    for (const PanelDrawing::Command& c : drawing.commands_) {
        Eigen::Vector4f seen = c.clip.cwiseMax(whole);
        seen.tail<2>() = c.clip.tail<2>().cwiseMin(whole.tail<2>());
        if (!(seen.x() < seen.z() && seen.y() < seen.w())) continue;
        const bool letters = c.texture == field_.id();
        glUniform4fv(shader::clip_rectangle_uniform, 1, seen.data());
        glUniform1ui(shader::panel_fill_uniform, letters ? shader::fill_letters : shader::fill_picture);
        if (!letters) glBindTextureUnit(shader::shown_picture_unit, c.texture);
        glDrawElementsBaseVertex(GL_TRIANGLES, c.indices, index_type,
                                 reinterpret_cast<const void*>(c.first_index * sizeof(ImDrawIdx)),
                                 c.first_vertex);
    }
    end_over_picture();
    gl::check("drawing a panel");
}

}  // namespace vantage
