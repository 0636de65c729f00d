#include "player/render/picture.h"

#include <png.h>

#include <array>
#include <cstring>

#include "base/files/png_file.h"
#include "base/gl/context.h"
#include "base/text/error.h"

namespace vantage {

Picture take_picture(Renderer& renderer, const View& view, const RenderSettings& settings,
                     std::span<const std::uint32_t> photos, int side) {
    FrameReport report;
    for (const PixelSample sample : renderer.samples(view, settings, side))
        report = renderer.draw(view, settings, photos, sample, 0);
    Picture p = shown_picture(renderer, view, settings);
    p.report = report;
    return p;
}

Picture shown_picture(Renderer& renderer, const View& view, const RenderSettings& settings) {
    return picture_of(frame_size(view), [&](GLuint target) { renderer.show(view, settings, {target}); });
}

Picture picture_of(FrameSize size, const std::function<void(GLuint target)>& show) {
    Picture p{size.width, size.height, {}, {}};
    const gl::Texture color = gl::make_texture_2d("picture", GL_RGBA8, p.width, p.height);
    const gl::Framebuffer target = gl::make_framebuffer("picture", std::array{color.id()}, 0);
    show(target.id());
    p.rgba.resize(std::size_t(p.width) * std::size_t(p.height) * 4);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(color.id(), 0, GL_RGBA, GL_UNSIGNED_BYTE, GLsizei(p.rgba.size()), p.rgba.data());
    gl::check("reading the picture");
    return p;
}

void write_png(const std::filesystem::path& file, const Picture& picture) {
    write_png(file, picture.width, picture.height, picture.rgba);
}

Picture read_png(const std::filesystem::path& file) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    Picture picture;
    if (png_image_begin_read_from_file(&image, file.c_str())) {
        image.format = PNG_FORMAT_RGBA;
        picture.width = int(image.width);
        picture.height = int(image.height);
        picture.rgba.resize(PNG_IMAGE_SIZE(image));
        if (png_image_finish_read(&image, nullptr, picture.rgba.data(), 0, nullptr)) return picture;
    }
    const std::string why = image.message;
    png_image_free(&image);
    throw Error(Exit::input, file.string() + ": cannot be read: " + why);
}

}  // namespace vantage
