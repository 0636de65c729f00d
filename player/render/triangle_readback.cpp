#include "player/render/triangle_readback.h"

#include <algorithm>
#include <array>

namespace vantage {

void TriangleReadback::release() {
    small_target_ = {};
    small_ = {};
    pixels_.release();
    width_ = height_ = 0;
}

void TriangleReadback::capture(const FrameTargets& targets, const View& view) {
    if (pixels_.pending()) return;
    const int width = std::max(1, targets.width / step), height = std::max(1, targets.height / step);
    if (width != width_ || height != height_) {
        small_ = gl::make_texture_2d("seen triangles", GL_R32UI, width, height);
        small_target_ = gl::make_framebuffer("seen triangles", std::array{small_.id()}, 0);
        pixels_.allocate("seen triangles", std::size_t(width) * std::size_t(height));
        width_ = width;
        height_ = height;
    }
    if (!pixels_) return;
    glNamedFramebufferReadBuffer(targets.surface_target.id(), GL_COLOR_ATTACHMENT1);
    glBlitNamedFramebuffer(targets.surface_target.id(), small_target_.id(), 0, 0, targets.width,
                           targets.height, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, pixels_.id());
    glGetTextureImage(small_.id(), 0, GL_RED_INTEGER, GL_UNSIGNED_INT, GLsizei(width_) * height_ * 4,
                      nullptr);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    pixels_.begin();
    captured_ = view;
}

bool TriangleReadback::update(bool wait) {
    const auto arrived = pixels_.take(wait);
    if (!arrived) return false;
    view_ = captured_;
    if (std::ranges::equal(*arrived, triangles_)) return false;
    triangles_.assign(arrived->begin(), arrived->end());
    ++version_;
    return true;
}

}  // namespace vantage
