#include "pipeline/reports/page/embedded_picture.h"

#include <fmt/format.h>
#include <turbojpeg.h>

#include <memory>
#include <string_view>

#include "base/text/error.h"
#include "base/text/markup.h"
#include "pipeline/reports/page/base64.h"

namespace vantage {
namespace {

constexpr int quality = 85;
constexpr int ground = 200;  ///< gray level behind transparent pixels

std::vector<std::uint8_t> on_gray(const RgbaImage& picture) {
    std::vector<std::uint8_t> rgb(picture.rgba.size() / 4 * 3);
    for (std::size_t p = 0; p < picture.rgba.size() / 4; ++p) {
        const int alpha = picture.rgba[4 * p + 3];
        for (std::size_t c = 0; c < 3; ++c)
            rgb[3 * p + c] = std::uint8_t((picture.rgba[4 * p + c] * alpha + ground * (255 - alpha)) / 255);
    }
    return rgb;
}

}  // namespace

std::string embedded_picture(const RgbaImage& picture, const std::string& description) {
    const std::unique_ptr<void, int (*)(tjhandle)> encoder(tjInitCompress(), tjDestroy);
    const std::vector<std::uint8_t> rgb = on_gray(picture);
    unsigned char* bytes = nullptr;
    unsigned long size = 0;
    const int failed = tjCompress2(encoder.get(), rgb.data(), picture.width, 0, picture.height, TJPF_RGB,
                                   &bytes, &size, TJSAMP_420, quality, 0);
    const std::unique_ptr<unsigned char, void (*)(unsigned char*)> owned(bytes, tjFree);
    if (failed)
        throw Error(Exit::storage, std::string("cannot encode a picture: ") + tjGetErrorStr2(encoder.get()));
    return fmt::format("<img width=\"{}\" height=\"{}\" alt=\"{}\" src=\"data:image/jpeg;base64,{}\">",
                       picture.width, picture.height, escaped(description),
                       base64(std::string_view(reinterpret_cast<const char*>(bytes), size)));
}

}  // namespace vantage
