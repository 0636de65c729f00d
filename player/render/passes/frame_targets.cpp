#include "player/render/passes/frame_targets.h"

#include <array>
#include <string>
#include <utility>

#include "base/text/error.h"

namespace vantage {
namespace {

constexpr GLenum depth_format = GL_DEPTH_COMPONENT32F, shaded_format = GL_RGBA16F,
                 triangles_format = GL_R32UI;

SurfaceTargets with_framebuffer(gl::Texture depth, gl::Texture shaded, gl::Texture triangles) {
    SurfaceTargets out{std::move(depth), std::move(shaded), std::move(triangles), {}};
    out.target = gl::make_framebuffer("frame surface", std::array{out.shaded.id(), out.triangles.id()},
                                      out.depth.id());
    return out;
}

SurfaceTargets make_surface(FrameSize allocated) {
    const auto make = [&](const char* label, GLenum format) {
        return gl::make_texture_2d(label, format, allocated.width, allocated.height);
    };
    return with_framebuffer(make("frame depth", depth_format), make("frame surface", shaded_format),
                            make("frame triangles", triangles_format));
}

SurfaceTargets make_layers(FrameSize allocated) {
    const auto make = [&](const char* label, GLenum format) {
        return gl::make_texture_array(label, format, allocated.width, allocated.height, 2, GL_NEAREST);
    };
    return with_framebuffer(make("depth of both eyes", depth_format),
                            make("surface of both eyes", shaded_format),
                            make("triangles of both eyes", triangles_format));
}

SurfaceTargets layer_of(const SurfaceTargets& layers, int layer) {
    return with_framebuffer(
        gl::make_layer_view("frame depth", layers.depth, depth_format, layer),
        gl::make_layer_view("frame surface", layers.shaded, shaded_format, layer),
        gl::make_layer_view("frame triangles", layers.triangles, triangles_format, layer));
}

}  // namespace

void bind_target(GLuint framebuffer, FrameSize size) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, size.width, size.height);
}

std::vector<std::uint32_t> read_triangles(const FrameTargets& targets) {
    std::vector<std::uint32_t> out(std::size_t(targets.width) * std::size_t(targets.height));
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glGetTextureSubImage(targets.surface().triangles.id(), 0, 0, 0, 0, targets.width, targets.height, 1,
                         GL_RED_INTEGER, GL_UNSIGNED_INT, GLsizei(out.size() * 4), out.data());
    return out;
}

FrameTargets make_frame_targets(FrameSize allocated, std::size_t eyes, std::size_t surfaces) {
    const auto [width, height] = allocated;
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    if (width < 1 || height < 1 || width > most || height > most)
        throw Error(Exit::usage, "a picture of " + std::to_string(width) + "x" + std::to_string(height) +
                                     ", expected 1 to " + std::to_string(most) + " along each side");
    FrameTargets t;
    t.allocated = allocated;
    t.width = width;
    t.height = height;
    if (surfaces > 1) {
        t.layers = make_layers(allocated);
        for (const int layer : {0, 1}) t.surfaces.push_back(layer_of(t.layers, layer));
    } else {
        t.surfaces.push_back(make_surface(allocated));
    }
    for (gl::Texture& sums : t.sums) sums = gl::make_texture_2d("frame sums", GL_RGBA32F, width, height);
    const auto sums_target = [](const gl::Texture& sums, const SurfaceTargets& surface) {
        return gl::make_framebuffer("frame sums", std::array{sums.id()}, surface.depth.id());
    };
    for (const SurfaceTargets& s : t.surfaces)
        t.sums_targets.push_back({sums_target(t.sums[0], s), sums_target(t.sums[1], s)});
    t.before = gl::make_texture_2d("frame before", GL_RGBA16F, width, height);
    t.before_target = gl::make_framebuffer("frame before", std::array{t.before.id()}, 0);
    for (std::size_t eye = 0; eye < eyes; ++eye) t.samples.push_back(make_picture_samples(allocated));
    return t;
}

std::uint64_t FrameTargets::bytes(FrameSize allocated, std::size_t eyes, std::size_t surfaces) {
    const auto [width, height] = allocated;
    return std::uint64_t(width) * std::uint64_t(height) * (surfaces * (4 + 8 + 4) + 8 + 32) +
           eyes * PictureSamples::bytes(width, height);
}

}  // namespace vantage
