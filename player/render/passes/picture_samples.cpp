#include "player/render/passes/picture_samples.h"

#include <array>

namespace vantage {

PictureSamples make_picture_samples(FrameSize allocated) {
    PictureSamples s;
    s.allocated = allocated;
    s.sum = gl::make_texture_2d("frame samples", GL_RGBA32F, allocated.width, allocated.height);
    s.sum_target = gl::make_framebuffer("frame samples", std::array{s.sum.id()}, 0);
    return s;
}

void PictureSamples::add_other() {
    if (other) return;
    other = gl::make_texture_2d("frame samples of another image set", GL_RGBA32F, allocated.width,
                                allocated.height);
    other_target = gl::make_framebuffer("frame samples of another image set", std::array{other.id()}, 0);
    const std::array<float, 4> zero{};
    glClearNamedFramebufferfv(other_target.id(), GL_COLOR, 0, zero.data());
}

void PictureSamples::add_veil() {
    if (veil) return;
    veil = gl::make_texture_2d("frame veil", GL_RGBA16F, allocated.width, allocated.height);
    clean = gl::make_texture_2d("frame clean", GL_RGBA32F, allocated.width, allocated.height);
    veiled_target =
        gl::make_framebuffer("frame samples and veil", std::array{sum.id(), veil.id(), clean.id()}, 0);
}

}  // namespace vantage
