#include "output/png_file.h"

#include <png.h>
#include <unistd.h>

#include <string>
#include <system_error>

#include "scene/error.h"

namespace vantage {

void write_png(const std::filesystem::path& file, int width, int height, std::span<const std::uint8_t> rgba) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = png_uint_32(width);
    image.height = png_uint_32(height);
    image.format = PNG_FORMAT_RGBA;
    const std::filesystem::path part = file.string() + ".part-" + std::to_string(::getpid());
    const bool written = png_image_write_to_file(&image, part.c_str(), 0, rgba.data(), 0, nullptr) != 0;
    std::error_code error;
    if (written) std::filesystem::rename(part, file, error);
    if (written && !error) return;
    std::filesystem::remove(part, error);
    throw Error(Exit::storage,
                file.string() + ": cannot be written: " +
                    (written ? std::string("not renamed into place") : std::string(image.message)));
}

}  // namespace vantage
