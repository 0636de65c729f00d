#include "base/files/png_file.h"

#include <png.h>

#include "base/files/replace_file.h"

namespace vantage {

void write_png(const std::filesystem::path& file, int width, int height, std::span<const std::uint8_t> rgba) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = png_uint_32(width);
    image.height = png_uint_32(height);
    image.format = PNG_FORMAT_RGBA;
    const UnfinishedFile out(file);
    if (!png_image_write_to_file(&image, out.part().c_str(), 0, rgba.data(), 0, nullptr))
        out.fail(image.message);
    out.finish();
}

}  // namespace vantage
