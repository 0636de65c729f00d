#include "player/render/hole_filling.h"

#include <algorithm>
#include <array>
#include <utility>

#include "shaders/contract.h"

namespace vantage {
namespace {

/// From half the frame's size down to one texel.
std::vector<std::pair<int, int>> level_sizes(int width, int height) {
    std::vector<std::pair<int, int>> out;
    do {
        width = (width + 1) / 2;
        height = (height + 1) / 2;
        out.emplace_back(width, height);
    } while (width > 1 || height > 1);
    return out;
}

gl::Program full_frame_program(const char* label, const char* fragment_shader) {
    return gl::make_program(label,
                            {{GL_VERTEX_SHADER, "resolve.vert"}, {GL_FRAGMENT_SHADER, fragment_shader}});
}

}  // namespace

HoleFilling::HoleFilling()
    : average_program_(full_frame_program("average holes", "average_holes.frag")),
      fill_program_(full_frame_program("fill holes", "fill_holes.frag")),
      no_vertices_(gl::make_vertex_array("no vertices")) {}

void HoleFilling::fit(int width, int height) {
    levels_.clear();
    for (const auto& [w, h] : level_sizes(width, height)) {
        gl::Texture texture = gl::make_texture_2d("filled holes", GL_RGBA32F, w, h, GL_LINEAR);
        gl::Framebuffer target = gl::make_framebuffer("filled holes", std::array{texture.id()}, 0);
        levels_.push_back({std::move(texture), std::move(target)});
    }
}

std::uint64_t HoleFilling::bytes(int width, int height) {
    std::uint64_t out = 0;
    for (const auto& [w, h] : level_sizes(width, height)) out += 16 * std::uint64_t(w) * std::uint64_t(h);
    return out;
}

float HoleFilling::hole_weight(int width, int height) {
    const float side = 0.125f * float(std::max(width, height));
    return 1 / std::max(side * side, 1.0f);
}

void HoleFilling::fill(const gl::Texture& accumulated, int width, int height, double samples) {
    const auto sizes = level_sizes(width, height);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glBindVertexArray(no_vertices_.id());
    const auto draw_to = [&](std::size_t level) {
        glBindFramebuffer(GL_FRAMEBUFFER, levels_[level].target.id());
        glViewport(0, 0, sizes[level].first, sizes[level].second);
        glDrawArrays(GL_TRIANGLES, 0, 3);
    };
    glUseProgram(average_program_.id());
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        const auto [w, h] = i == 0 ? std::pair(width, height) : sizes[i - 1];
        glUniform2i(shader::frame_size_uniform, w, h);
        glUniform1f(shader::average_samples_uniform, i == 0 ? float(samples) : 0.0f);
        glBindTextureUnit(shader::finer_unit, i == 0 ? accumulated.id() : levels_[i - 1].texture.id());
        draw_to(i);
    }
    glUseProgram(fill_program_.id());
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE_MINUS_DST_ALPHA, GL_ONE);
    for (std::size_t i = sizes.size() - 1; i-- > 0;) {
        glUniform2i(shader::frame_size_uniform, sizes[i + 1].first, sizes[i + 1].second);
        glBindTextureUnit(shader::coarser_unit, levels_[i + 1].texture.id());
        draw_to(i);
    }
    glDisable(GL_BLEND);
}

}  // namespace vantage
