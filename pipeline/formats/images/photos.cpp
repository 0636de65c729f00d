#include "pipeline/formats/images/photos.h"

#include <turbojpeg.h>

#include <algorithm>
#include <memory>
#include <string_view>

#include "pipeline/run/read_file.h"

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
RgbaImage from_cmyk(const RgbaImage& cmyk) {
    RgbaImage out = cmyk;
    for (std::size_t i = 0; i < out.rgba.size(); i += 4) {
        for (std::size_t c = 0; c < 3; ++c)
            out.rgba[i + c] = std::uint8_t((unsigned(cmyk.rgba[i + c]) * cmyk.rgba[i + 3] + 127) / 255);
        out.rgba[i + 3] = 255;
    }
    return out;
}

struct JpegHeader {
    Decoder decoder;
    bool readable = false;
    int width = 0, height = 0, space = 0;
};

JpegHeader jpeg_header(std::span<const std::byte> bytes) {
    JpegHeader h{Decoder(tjInitDecompress(), tjDestroy)};
    int subsampling = 0;
    h.readable = tjDecompressHeader3(h.decoder.get(), data(bytes), bytes.size(), &h.width, &h.height,
                                     &subsampling, &h.space) == 0;
    return h;
}

[[noreturn]] void refuse_size(const std::filesystem::path& file, PhotoSize is, PhotoSize expected) {
    refuse(file, "is " + std::to_string(is.width) + "x" + std::to_string(is.height) +
                     ", its camera expects " + std::to_string(expected.width) + "x" +
                     std::to_string(expected.height));
}

/// One is the other, perhaps turned.
bool fits(PhotoSize is, PhotoSize expected) {
    return (is.width == expected.width && is.height == expected.height) ||
           (is.width == expected.height && is.height == expected.width);
}

RgbaImage decode_jpeg(const std::filesystem::path& file, std::span<const std::byte> bytes,
                      PhotoSize expected) {
    const JpegHeader h = jpeg_header(bytes);
    if (!h.readable) refuse(file, std::string("not a readable JPEG: ") + tjGetErrorStr2(h.decoder.get()));
    // Before memory is taken for what a broken header says.
    if (!fits({h.width, h.height}, expected)) refuse_size(file, {h.width, h.height}, expected);
    RgbaImage photo{h.width, h.height,
                    std::vector<std::uint8_t>(std::size_t(h.width) * std::size_t(h.height) * 4), true};
    const bool cmyk = h.space == TJCS_CMYK || h.space == TJCS_YCCK;
    if (tjDecompress2(h.decoder.get(), data(bytes), bytes.size(), photo.rgba.data(), h.width, 0, h.height,
                      cmyk ? TJPF_CMYK : TJPF_RGBA, TJFLAG_ACCURATEDCT))
        refuse(file, std::string("JPEG is damaged or cut short: ") + tjGetErrorStr2(h.decoder.get()));
    if (cmyk) return from_cmyk(photo);
    return photo;
}

/// Turns by EXIF orientation 5 to 8, those that swap width and height.
RgbaImage turned(const RgbaImage& p, int orientation) {
    RgbaImage out{p.height, p.width, std::vector<std::uint8_t>(p.rgba.size()), p.opaque};
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
    // Size and profile of a JPEG stand before the picture.
    const std::vector<std::byte> head = read_file(file, std::size_t(1) << 18);
    const std::string_view text(reinterpret_cast<const char*>(head.data()), head.size());
    if (is_jpeg(head) && text.find("ICC_PROFILE") == text.npos)
        if (const JpegHeader jpeg = jpeg_header(head); jpeg.readable)
            return {{jpeg.width, jpeg.height}, {}, 1};
    return image_files().header(file);
}

RgbaImage read_photo(const std::filesystem::path& file, PhotoSize expected) {
    return decode_photo(file, read_file(file), expected);
}

RgbaImage decode_photo(const std::filesystem::path& file, std::span<const std::byte> bytes,
                       PhotoSize expected) {
    RgbaImage photo = is_jpeg(bytes) ? decode_jpeg(file, bytes, expected) : image_files().read(file);
    if (photo.width == expected.height && photo.height == expected.width && photo.width != photo.height)
        if (const int o = image_files().header(file).orientation; o >= 5 && o <= 8) photo = turned(photo, o);
    if (photo.width != expected.width || photo.height != expected.height)
        refuse_size(file, {photo.width, photo.height}, expected);
    return photo;
}

std::string reason_of(const Error& error, const std::filesystem::path& file) {
    const std::string message = error.what();
    for (const std::string& prefix : {file.string() + ": ", file.filename().string() + ": "})
        if (message.starts_with(prefix)) return message.substr(prefix.size());
    return message;
}

}  // namespace vantage
