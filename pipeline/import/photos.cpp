#include "pipeline/import/photos.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>
#include <turbojpeg.h>

#include <memory>

#include "pipeline/file_identity.h"
#include "scene/error.h"

namespace vantage {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& why) {
    throw Error(Exit::input, file.string() + ": " + why);
}

const unsigned char* data(std::span<const std::byte> b) {
    return reinterpret_cast<const unsigned char*>(b.data());
}

bool is_jpeg(std::span<const std::byte> b) {
    return b.size() > 3 && b[0] == std::byte(0xff) && b[1] == std::byte(0xd8);
}

using Decoder = std::unique_ptr<void, int (*)(tjhandle)>;

/// Adobe's CMYK is stored inverted: a channel is ink left out, so colour is the product with K.
RgbaPhoto from_cmyk(const RgbaPhoto& cmyk) {
    RgbaPhoto out = cmyk;
    for (std::size_t i = 0; i < out.rgba.size(); i += 4) {
        for (std::size_t c = 0; c < 3; ++c)
            out.rgba[i + c] = std::uint8_t((unsigned(cmyk.rgba[i + c]) * cmyk.rgba[i + 3] + 127) / 255);
        out.rgba[i + 3] = 255;
    }
    return out;
}

RgbaPhoto decode_jpeg(const std::filesystem::path& file, std::span<const std::byte> bytes) {
    const Decoder decoder(tjInitDecompress(), tjDestroy);
    int width = 0, height = 0, subsampling = 0, space = 0;
    if (tjDecompressHeader3(decoder.get(), data(bytes), bytes.size(), &width, &height, &subsampling, &space))
        refuse(file, std::string("not a readable JPEG: ") + tjGetErrorStr2(decoder.get()));
    RgbaPhoto photo{width, height, std::vector<std::uint8_t>(std::size_t(width) * std::size_t(height) * 4)};
    const bool cmyk = space == TJCS_CMYK || space == TJCS_YCCK;
    if (tjDecompress2(decoder.get(), data(bytes), bytes.size(), photo.rgba.data(), width, 0, height,
                      cmyk ? TJPF_CMYK : TJPF_RGBA, TJFLAG_ACCURATEDCT))
        refuse(file, std::string("JPEG is damaged or cut short: ") + tjGetErrorStr2(decoder.get()));
    return cmyk ? from_cmyk(photo) : photo;
}

RgbaPhoto decode_other(const std::filesystem::path& file) {
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    OIIO::ImageBuf image(file.string(), 0, 0, nullptr, &config);
    if (!image.read(0, 0, true, OIIO::TypeDesc::UINT8)) refuse(file, "cannot read: " + image.geterror());
    const OIIO::ImageSpec& spec = image.spec();
    const int n = spec.nchannels;
    const int order[] = {0, n >= 3 ? 1 : 0, n >= 3 ? 2 : 0, n == 2 ? 1 : n >= 4 ? 3 : -1};
    const float fill[] = {0, 0, 0, 1};
    const OIIO::ImageBuf rgba = OIIO::ImageBufAlgo::channels(image, 4, order, fill);
    RgbaPhoto photo{spec.width, spec.height,
                    std::vector<std::uint8_t>(std::size_t(spec.width) * std::size_t(spec.height) * 4)};
    if (!rgba.get_pixels(rgba.roi(), OIIO::TypeDesc::UINT8, photo.rgba.data()))
        refuse(file, "cannot read: " + rgba.geterror());
    return photo;
}

int orientation(const std::filesystem::path& file) {
    const auto in = OIIO::ImageInput::open(file.string());
    return in ? in->spec().get_int_attribute("Orientation", 1) : 1;
}

/// Turns by EXIF orientation 5 to 8, those that swap width and height.
RgbaPhoto turned(const RgbaPhoto& p, int orientation) {
    RgbaPhoto out{p.height, p.width, std::vector<std::uint8_t>(p.rgba.size())};
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            const int sx = orientation == 5 || orientation == 6 ? y : p.width - 1 - y;
            const int sy = orientation == 5 || orientation == 8 ? x : p.height - 1 - x;
            const std::size_t from = (std::size_t(sy) * std::size_t(p.width) + std::size_t(sx)) * 4;
            const std::size_t to = (std::size_t(y) * std::size_t(out.width) + std::size_t(x)) * 4;
            std::copy_n(p.rgba.begin() + std::ptrdiff_t(from), 4, out.rgba.begin() + std::ptrdiff_t(to));
        }
    return out;
}

}  // namespace

PhotoHeader read_photo_header(const std::filesystem::path& file) {
    const auto in = OIIO::ImageInput::open(file.string());
    if (!in) refuse(file, "not a readable photo: " + OIIO::geterror());
    const OIIO::ImageSpec& spec = in->spec();
    PhotoHeader header{{spec.width, spec.height}, {}};
    if (!spec.find_attribute("ICCProfile")) return header;
    header.profile = spec.get_string_attribute("ICCProfile:profile_description", "without a name");
    if (header.profile.find("sRGB") != std::string::npos) header.profile.clear();
    return header;
}

RgbaPhoto read_photo(const std::filesystem::path& file, PhotoSize expected) {
    return decode_photo(file, read_file(file), expected);
}

RgbaPhoto decode_photo(const std::filesystem::path& file, std::span<const std::byte> bytes,
                       PhotoSize expected) {
    RgbaPhoto photo = is_jpeg(bytes) ? decode_jpeg(file, bytes) : decode_other(file);
    if (photo.width == expected.height && photo.height == expected.width && photo.width != photo.height)
        if (const int o = orientation(file); o >= 5 && o <= 8) photo = turned(photo, o);
    if (photo.width != expected.width || photo.height != expected.height)
        refuse(file, "is " + std::to_string(photo.width) + "x" + std::to_string(photo.height) +
                         ", its camera expects " + std::to_string(expected.width) + "x" +
                         std::to_string(expected.height));
    return photo;
}

}  // namespace vantage
