#include "pipeline/import/photos.h"

#include <turbojpeg.h>

#include <algorithm>
#include <memory>
#include <string_view>

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

struct JpegHeader {
    Decoder decoder;
    int width = 0, height = 0, space = 0;
};

JpegHeader jpeg_header(const std::filesystem::path& file, std::span<const std::byte> bytes) {
    JpegHeader h{Decoder(tjInitDecompress(), tjDestroy)};
    int subsampling = 0;
    if (tjDecompressHeader3(h.decoder.get(), data(bytes), bytes.size(), &h.width, &h.height, &subsampling,
                            &h.space))
        refuse(file, std::string("not a readable JPEG: ") + tjGetErrorStr2(h.decoder.get()));
    return h;
}

RgbaPhoto decode_jpeg(const std::filesystem::path& file, std::span<const std::byte> bytes) {
    const JpegHeader h = jpeg_header(file, bytes);
    RgbaPhoto photo{h.width, h.height,
                    std::vector<std::uint8_t>(std::size_t(h.width) * std::size_t(h.height) * 4)};
    const bool cmyk = h.space == TJCS_CMYK || h.space == TJCS_YCCK;
    if (tjDecompress2(h.decoder.get(), data(bytes), bytes.size(), photo.rgba.data(), h.width, 0, h.height,
                      cmyk ? TJPF_CMYK : TJPF_RGBA, TJFLAG_ACCURATEDCT))
        refuse(file, std::string("JPEG is damaged or cut short: ") + tjGetErrorStr2(h.decoder.get()));
    return cmyk ? from_cmyk(photo) : photo;
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
    const std::vector<std::byte> bytes = read_file(file);
    // Where profiles are: before the picture.
    const std::string_view head(reinterpret_cast<const char*>(bytes.data()),
                                std::min(bytes.size(), std::size_t(1) << 18));
    if (!is_jpeg(bytes) || head.find("ICC_PROFILE") != head.npos) return image_files().header(file);
    const JpegHeader jpeg = jpeg_header(file, bytes);
    return {{jpeg.width, jpeg.height}, {}, 1};
}

RgbaPhoto read_photo(const std::filesystem::path& file, PhotoSize expected) {
    return decode_photo(file, read_file(file), expected);
}

RgbaPhoto decode_photo(const std::filesystem::path& file, std::span<const std::byte> bytes,
                       PhotoSize expected) {
    RgbaPhoto photo = is_jpeg(bytes) ? decode_jpeg(file, bytes) : image_files().read(file);
    if (photo.width == expected.height && photo.height == expected.width && photo.width != photo.height)
        if (const int o = image_files().header(file).orientation; o >= 5 && o <= 8) photo = turned(photo, o);
    if (photo.width != expected.width || photo.height != expected.height)
        refuse(file, "is " + std::to_string(photo.width) + "x" + std::to_string(photo.height) +
                         ", its camera expects " + std::to_string(expected.width) + "x" +
                         std::to_string(expected.height));
    return photo;
}

}  // namespace vantage
