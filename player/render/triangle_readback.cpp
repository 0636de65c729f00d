#include "player/render/triangle_readback.h"

#include <algorithm>
#include <array>

namespace vantage {

TriangleReadback::~TriangleReadback() { release(); }

void TriangleReadback::release() {
    if (fence_) glDeleteSync(fence_);
    fence_ = nullptr;
    mapped_ = nullptr;
    small_target_ = {};
    small_ = {};
    pixels_ = {};
    width_ = height_ = 0;
}

void TriangleReadback::capture(const FrameTargets& targets, const View& view) {
    if (fence_) return;
    const int width = std::max(1, targets.width / step), height = std::max(1, targets.height / step);
    if (width != width_ || height != height_) {
        small_ = gl::make_texture_2d("seen triangles", GL_R32UI, width, height);
        small_target_ = gl::make_framebuffer("seen triangles", std::array{small_.id()}, 0);
        constexpr GLbitfield flags = GL_MAP_READ_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
        const GLsizeiptr bytes = GLsizeiptr(width) * height * 4;
        pixels_ = gl::make_buffer("seen triangles", std::size_t(bytes), nullptr, flags);
        mapped_ = static_cast<const std::uint32_t*>(glMapNamedBufferRange(pixels_.id(), 0, bytes, flags));
        width_ = width;
        height_ = height;
    }
    glNamedFramebufferReadBuffer(targets.surface_target.id(), GL_COLOR_ATTACHMENT1);
    glBlitNamedFramebuffer(targets.surface_target.id(), small_target_.id(), 0, 0, targets.width,
                           targets.height, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, pixels_.id());
    glGetTextureImage(small_.id(), 0, GL_RED_INTEGER, GL_UNSIGNED_INT, GLsizei(width_) * height_ * 4,
                      nullptr);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    fence_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    captured_ = view;
}

bool TriangleReadback::update(bool wait) {
    if (!fence_ || !mapped_) return false;
    constexpr GLuint64 second = 1'000'000'000;
    const GLenum state = glClientWaitSync(fence_, GL_SYNC_FLUSH_COMMANDS_BIT, wait ? 10 * second : 0);
    if (state == GL_TIMEOUT_EXPIRED) return false;
    glDeleteSync(fence_);
    fence_ = nullptr;
    view_ = captured_;
    const std::size_t count = std::size_t(width_) * std::size_t(height_);
    const std::span<const std::uint32_t> arrived(mapped_, count);
    if (std::ranges::equal(arrived, triangles_)) return false;
    triangles_.assign(arrived.begin(), arrived.end());
    ++version_;
    return true;
}

}  // namespace vantage
