#include "player/render/passes/hole_filling.h"

#include <algorithm>
#include <array>
#include <utility>

#include "player/render/passes/full_frame_program.h"
#include "shaders/contract.h"

namespace vantage {
namespace {

/// The size of a level; level 0 has half the frame's size.
FrameSize level_size(FrameSize frame, std::size_t level) {
    const auto halved = [&](int n) { return ((n - 1) >> (level + 1)) + 1; };
    return {halved(frame.width), halved(frame.height)};
}

/// The number of levels, down to a level of one texel.
std::size_t level_count(FrameSize frame) {
    std::size_t n = 1;
    while (level_size(frame, n - 1) != FrameSize{1, 1}) ++n;
    return n;
}

}  // namespace

HoleFilling::HoleFilling()
    : average_program_(full_frame_program("average holes", "average_holes.frag")),
      fill_program_(full_frame_program("fill holes", "fill_holes.frag")),
      no_vertices_(gl::make_vertex_array("no vertices")) {}

void HoleFilling::fit(int width, int height) {
    levels_.clear();
    for (std::size_t i = 0; i < level_count({width, height}); ++i) {
        const auto [w, h] = level_size({width, height}, i);
        gl::Texture whole = gl::make_texture_2d("filled holes", GL_RGBA32F, w, h, GL_LINEAR),
                    behind = gl::make_texture_2d("filled background", GL_RGBA32F, w, h, GL_LINEAR);
        gl::Framebuffer target = gl::make_framebuffer("filled holes", std::array{whole.id(), behind.id()}, 0);
        levels_.push_back({std::move(whole), std::move(behind), std::move(target)});
    }
}

std::uint64_t HoleFilling::bytes(int width, int height) {
    std::uint64_t out = 0;
    for (std::size_t i = 0; i < level_count({width, height}); ++i) {
        const auto [w, h] = level_size({width, height}, i);
        out += 32 * std::uint64_t(w) * std::uint64_t(h);
    }
    return out;
}

float HoleFilling::hole_weight(int width, int height) {
    const float side = 0.125f * float(std::max(width, height));
    return 1 / std::max(side * side, 1.0f);
}

void HoleFilling::fill(const gl::Texture& accumulated, GLuint surface, const FrameTargets& targets,
                       double samples) {
    const FrameSize frame = targets.size();
    const std::size_t levels = level_count(frame);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glBindVertexArray(no_vertices_.id());
    const auto draw_to = [&](std::size_t level) {
        bind_target(levels_[level].target.id(), level_size(frame, level));
        glDrawArrays(GL_TRIANGLES, 0, 3);
    };
    glUseProgram(average_program_.id());
    glBindTextureUnit(shader::surface_unit, surface);
    glUniform1i(shader::fine_uniform, targets.fine);
    for (std::size_t i = 0; i < levels; ++i) {
        const FrameSize finer = i == 0 ? frame : level_size(frame, i - 1);
        glUniform2i(shader::frame_size_uniform, finer.width, finer.height);
        glUniform1f(shader::average_samples_uniform, i == 0 ? float(samples) : 0.0f);
        glBindTextureUnit(shader::finer_unit, i == 0 ? accumulated.id() : levels_[i - 1].whole.id());
        glBindTextureUnit(shader::finer_behind_unit, i == 0 ? 0 : levels_[i - 1].behind.id());
        draw_to(i);
    }
    glUseProgram(fill_program_.id());
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE_MINUS_DST_ALPHA, GL_ONE);
    for (std::size_t i = levels - 1; i-- > 0;) {
        const FrameSize coarser = level_size(frame, i + 1);
        glUniform2i(shader::frame_size_uniform, coarser.width, coarser.height);
        glBindTextureUnit(shader::coarser_unit, levels_[i + 1].whole.id());
        glBindTextureUnit(shader::coarser_behind_unit, levels_[i + 1].behind.id());
        draw_to(i);
    }
    glDisable(GL_BLEND);
}

}  // namespace vantage
