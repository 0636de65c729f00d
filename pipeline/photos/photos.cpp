#include "pipeline/photos/photos.h"

#include <turbojpeg.h>

#include <algorithm>
#include <array>
#include <memory>

#include "base/values/grid.h"
#include "pipeline/photos/color_profile.h"
#include "pipeline/photos/jpeg_photo.h"
#include "pipeline/photos/reduced.h"
#include "pipeline/run/read_file.h"

namespace vantage {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& reason) {
    throw Error(Exit::input, file.string() + ": " + reason);
}

bool is_jpeg(std::span<const std::byte> b) {
    return b.size() > 3 && b[0] == std::byte(0xff) && b[1] == std::byte(0xd8);
}

/// Adobe stores CMYK inverted, 255 meaning no ink, so each color channel is multiplied by K.
RgbaImage from_cmyk(const RgbaImage& cmyk) {
    RgbaImage out = cmyk;
    for (std::size_t i = 0; i < out.rgba.size(); i += 4) {
        for (std::size_t c = 0; c < 3; ++c)
            out.rgba[i + c] = std::uint8_t((unsigned(cmyk.rgba[i + c]) * cmyk.rgba[i + 3] + 127) / 255);
        out.rgba[i + 3] = 255;
    }
    return out;
}

std::shared_ptr<const ColorProfile> profile_of(const JpegPhoto& jpeg) {
    return jpeg.profile ? color_profile(*jpeg.profile, jpeg.colors) : nullptr;
}

[[noreturn]] void fail_size(const std::filesystem::path& file, PhotoSize actual, PhotoSize expected) {
    fail(file, "is " + std::to_string(actual.width) + "x" + std::to_string(actual.height) +
                   ", but its camera expects " + std::to_string(expected.width) + "x" +
                   std::to_string(expected.height));
}

/// Whether the sizes are equal, possibly after a rotation by 90 degrees.
bool fits(PhotoSize actual, PhotoSize expected) {
    return (actual.width == expected.width && actual.height == expected.height) ||
           (actual.width == expected.height && actual.height == expected.width);
}

/// Whether colors of an ICC profile are converted.
enum class Profiles { used, ignored };

/// `reduction`: 1, 2, 4 or 8, the divisor of the photo's size (rounded up).
RgbaImage decode_jpeg(const std::filesystem::path& file, std::span<const std::byte> bytes, PhotoSize expected,
                      Profiles profiles, int reduction = 1) {
    const JpegPhoto h = read_jpeg_photo(bytes);
    if (!h.flaw.empty()) fail(file, "not a readable JPEG: " + h.flaw);
    // Checked before memory is allocated: a corrupt header may claim any size.
    if (!fits({h.width, h.height}, expected)) fail_size(file, {h.width, h.height}, expected);
    const auto reduced = [&](int length) { return TJSCALED(length, (tjscalingfactor{1, reduction})); };
    RgbaImage photo = blank_image(reduced(h.width), reduced(h.height));
    photo.opaque = true;
    const bool cmyk = h.colors == PixelColors::cmyk;
    const std::unique_ptr<void, int (*)(tjhandle)> decoder(tjInitDecompress(), tjDestroy);
    if (tjDecompress2(decoder.get(), reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(),
                      photo.rgba.data(), photo.width, 0, photo.height, cmyk ? TJPF_CMYK : TJPF_RGBA,
                      TJFLAG_ACCURATEDCT))
        fail(file, std::string("JPEG is corrupt or truncated: ") + tjGetErrorStr2(decoder.get()));
    const auto profile = profiles == Profiles::used ? profile_of(h) : nullptr;
    if (!profile || !profile->use.converts) return cmyk ? from_cmyk(photo) : photo;
    profile->convert(photo.rgba);
    return photo;
}

/// Applies an EXIF orientation that swaps width and height: 5 to 8.
RgbaImage transposed(const RgbaImage& p, int orientation) {
    using Pixel = std::array<std::uint8_t, 4>;
    RgbaImage out = blank_image(p.height, p.width);
    out.opaque = p.opaque;
    const Grid<const Pixel> from{reinterpret_cast<const Pixel*>(p.rgba.data()), p.width, p.height};
    const Grid<Pixel> to{reinterpret_cast<Pixel*>(out.rgba.data()), out.width, out.height};
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            const int sx = orientation == 5 || orientation == 6 ? y : p.width - 1 - y;
            const int sy = orientation == 5 || orientation == 8 ? x : p.height - 1 - x;
            to(x, y) = from(sx, sy);
        }
    return out;
}

RgbaImage decode(const std::filesystem::path& file, std::span<const std::byte> bytes, PhotoSize expected,
                 Profiles profiles) {
    RgbaImage photo = is_jpeg(bytes)               ? decode_jpeg(file, bytes, expected, profiles)
                      : profiles == Profiles::used ? image_files().read(file)
                                                   : image_files().read_unprofiled(file);
    if (photo.width == expected.height && photo.height == expected.width && photo.width != photo.height)
        if (const int o = read_photo_header(file).orientation; o >= 5 && o <= 8) photo = transposed(photo, o);
    if (photo.width != expected.width || photo.height != expected.height)
        fail_size(file, {photo.width, photo.height}, expected);
    return photo;
}

}  // namespace

PhotoHeader read_photo_header(const std::filesystem::path& file) {
    // In a JPEG, the size and the profile come before the image data, after metadata of any length.
    for (std::size_t bytes = std::size_t(1) << 18;; bytes *= 4) {
        const std::vector<std::byte> head = read_file(file, bytes);
        if (!is_jpeg(head)) break;
        if (const JpegPhoto jpeg = read_jpeg_photo(head); jpeg.flaw.empty()) {
            const auto profile = profile_of(jpeg);
            return {{jpeg.width, jpeg.height}, profile ? profile->use : ProfileUse{}, jpeg.orientation};
        }
        if (head.size() < bytes) break;
    }
    return image_files().header(file);
}

RgbaImage read_photo(const std::filesystem::path& file, PhotoSize expected) {
    return decode_photo(file, read_file(file), expected);
}

RgbaImage decode_photo(const std::filesystem::path& file, std::span<const std::byte> bytes,
                       PhotoSize expected) {
    return decode(file, bytes, expected, Profiles::used);
}

RgbaImage read_unprofiled(const std::filesystem::path& file, PhotoSize expected) {
    return decode(file, read_file(file), expected, Profiles::ignored);
}

ReducedPhoto read_reduced_photo(const std::filesystem::path& file, PhotoSize expected, int longest) {
    const std::vector<std::byte> bytes = read_file(file);
    const auto shrunk = [&](const RgbaImage& image, int reduction) {
        const Level size = thumbnail_size(image.width, image.height, longest);
        return ReducedPhoto{
            reduced(image, size),
            {double(reduction) * image.width / size.width, double(reduction) * image.height / size.height}};
    };
    if (!is_upright_jpeg(bytes, expected)) return shrunk(decode_photo(file, bytes, expected), 1);
    int reduction = 8;
    while (reduction > 1 && std::max(expected.width, expected.height) < reduction * longest) reduction /= 2;
    return shrunk(decode_jpeg(file, bytes, expected, Profiles::used, reduction), reduction);
}

bool is_upright_jpeg(std::span<const std::byte> bytes, PhotoSize size) {
    if (!is_jpeg(bytes)) return false;
    const JpegPhoto h = read_jpeg_photo(bytes);
    return h.flaw.empty() && h.width == size.width && h.height == size.height;
}

std::string reason_of(const Error& error, const std::filesystem::path& file) {
    std::string message = error.what();
    for (const std::string& prefix : {file.string() + ": ", file.filename().string() + ": "})
        if (message.starts_with(prefix)) {
            message.erase(0, prefix.size());
            break;
        }
    // Libraries may repeat the path.
    const std::string path = file.string(), name = file.filename().string();
    for (std::size_t at = 0; path != name && (at = message.find(path, at)) != message.npos; at += name.size())
        message.replace(at, path.size(), name);
    return message;
}

}  // namespace vantage
