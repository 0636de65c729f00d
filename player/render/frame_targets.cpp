#include "player/render/frame_targets.h"

#include <array>
#include <string>

#include "scene/error.h"

namespace vantage {

FrameTargets make_frame_targets(FrameSize room, bool half_sums, std::size_t eyes) {
    const auto [width, height] = room;
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    if (width < 1 || height < 1 || width > most || height > most)
        throw Error(Exit::usage, "a picture of " + std::to_string(width) + "x" + std::to_string(height) +
                                     ", expected 1 to " + std::to_string(most) + " along each side");
    FrameTargets t;
    t.room = room;
    t.width = width;
    t.height = height;
    t.half_sums = half_sums;
    t.depth = gl::make_texture_2d("frame depth", GL_DEPTH_COMPONENT32F, width, height);
    t.surface = gl::make_texture_2d("frame surface", GL_RGBA16F, width, height);
    t.triangles = gl::make_texture_2d("frame triangles", GL_R32UI, width, height);
    t.surface_target =
        gl::make_framebuffer("frame surface", std::array{t.surface.id(), t.triangles.id()}, t.depth.id());
    for (int i = 0; i < 2; ++i) {
        t.sums[i] = gl::make_texture_2d("frame sums", half_sums ? GL_RGBA16F : GL_RGBA32F, width, height);
        t.sums_target[i] = gl::make_framebuffer("frame sums", std::array{t.sums[i].id()}, t.depth.id());
    }
    t.before = gl::make_texture_2d("frame before", GL_RGBA16F, width, height);
    t.before_target = gl::make_framebuffer("frame before", std::array{t.before.id()}, 0);
    for (std::size_t eye = 0; eye < eyes; ++eye) t.samples.push_back(make_picture_samples(room));
    return t;
}

std::uint64_t FrameTargets::bytes(int width, int height, bool half_sums, std::size_t eyes) {
    return std::uint64_t(width) * std::uint64_t(height) * (4 + 8 + 4 + 8 + (half_sums ? 16 : 32)) +
           eyes * PictureSamples::bytes(width, height);
}

}  // namespace vantage
