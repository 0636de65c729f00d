#include "player/render/passes/frame_targets.h"

#include <algorithm>
#include <array>
#include <bit>
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

FrameSize fine_of(FrameSize frame, int fine) { return {frame.width * fine, frame.height * fine}; }

/// Side of a square map about as fine as a frame.
int shadow_side_of(FrameSize fine) {
    return int(std::bit_floor(unsigned(std::max({fine.width, fine.height, 1}))));
}

gl::Texture make_sums(FrameSize size) {
    return gl::make_texture_2d("frame sums", GL_RGBA32F, size.width, size.height);
}

gl::Framebuffer make_sums_target(const gl::Texture& sums, const SurfaceTargets& surface) {
    return gl::make_framebuffer("frame sums", std::array{sums.id()}, surface.depth.id());
}

}  // namespace

void bind_target(GLuint framebuffer, FrameSize size) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, size.width, size.height);
}

std::vector<std::uint32_t> read_triangles(const FrameTargets& targets) {
    const auto [width, height] = targets.fine_size();
    std::vector<std::uint32_t> all(std::size_t(width) * std::size_t(height)), out;
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glGetTextureSubImage(targets.surface().triangles.id(), 0, 0, 0, 0, width, height, 1, GL_RED_INTEGER,
                         GL_UNSIGNED_INT, GLsizei(all.size() * 4), all.data());
    for (int y = targets.fine - 1; y < height; y += targets.fine)
        for (int x = targets.fine - 1; x < width; x += targets.fine)
            out.push_back(all[std::size_t(y) * std::size_t(width) + std::size_t(x)]);
    return out;
}

void FrameTargets::add_second_sums() {
    if (sums[1]) return;
    sums[1] = make_sums(fine_of(allocated, fine));
    for (std::size_t i = 0; i < surfaces.size(); ++i)
        sums_targets[i][1] = make_sums_target(sums[1], surfaces[i]);
}

void FrameTargets::add_before() {
    if (before) return;
    const FrameSize size = fine_of(allocated, fine);
    before = gl::make_texture_2d("frame before", GL_RGBA16F, size.width, size.height);
    before_target = gl::make_framebuffer("frame before", std::array{before.id()}, 0);
}

int FrameTargets::shadow_side() const { return shadow_side_of(fine_of(allocated, fine)); }

int FrameTargets::used_shadow_side() const { return shadow_side_of(fine_size()); }

void FrameTargets::add_shadows() {
    if (shadows) return;
    shadows = gl::make_texture_2d("shadow map", depth_format, shadow_side(), shadow_side(), GL_LINEAR);
    glTextureParameteri(shadows.id(), GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTextureParameteri(shadows.id(), GL_TEXTURE_COMPARE_FUNC, GL_GEQUAL);
    shadows_target = gl::make_framebuffer("shadow map", {}, shadows.id());
}

FrameTargets make_frame_targets(FrameSize allocated, std::size_t eyes, std::size_t surfaces, int fine) {
    const auto [width, height] = fine_of(allocated, fine);
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    if (width < 1 || height < 1 || width > most || height > most)
        throw Error(Exit::usage, "a picture of " + std::to_string(width) + "x" + std::to_string(height) +
                                     ", expected 1 to " + std::to_string(most) + " along each side");
    FrameTargets t;
    t.allocated = allocated;
    t.fine = fine;
    t.width = allocated.width;
    t.height = allocated.height;
    if (surfaces > 1) {
        t.layers = make_layers({width, height});
        for (const int layer : {0, 1}) t.surfaces.push_back(layer_of(t.layers, layer));
    } else {
        t.surfaces.push_back(make_surface({width, height}));
    }
    t.sums[0] = make_sums({width, height});
    for (const SurfaceTargets& s : t.surfaces) t.sums_targets.push_back({make_sums_target(t.sums[0], s), {}});
    for (std::size_t eye = 0; eye < eyes; ++eye) t.samples.push_back(make_picture_samples(allocated));
    return t;
}

std::uint64_t FrameTargets::bytes(FrameSize allocated, std::size_t eyes, std::size_t surfaces, int fine) {
    const auto [width, height] = fine_of(allocated, fine);
    const auto shadows = std::uint64_t(shadow_side_of({width, height}));
    return std::uint64_t(width) * std::uint64_t(height) * (surfaces * (4 + 8 + 4) + 8 + 32) +
           4 * shadows * shadows + eyes * PictureSamples::bytes(allocated.width, allocated.height);
}

}  // namespace vantage
