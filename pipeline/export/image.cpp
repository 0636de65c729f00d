#include "pipeline/export/image.h"

#include <OpenImageIO/imageio.h>

#include "scene/error.h"

namespace vantage {

void write_image(const std::filesystem::path& file, int width, int height, int channels, OIIO::TypeDesc type,
                 std::span<const std::byte> pixels) {
    const auto out = OIIO::ImageOutput::create(file.string());
    OIIO::ImageSpec spec(width, height, channels, type);
    spec.attribute("Compression", file.extension() == ".jpg" ? "jpeg:97" : "zip");
    spec.attribute("jpeg:subsampling", "4:4:4");
    if (channels == 4) {
        spec.alpha_channel = 3;
        spec.attribute("oiio:UnassociatedAlpha", 1);
    }
    if (!out || !out->open(file.string(), spec) || !out->write_image(type, pixels.data()) || !out->close())
        throw Error(Exit::storage, file.string() + ": cannot write" + (out ? ": " + out->geterror() : ""));
}

}  // namespace vantage
