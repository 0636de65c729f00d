// The library that image_files() loads.
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>

#include "pipeline/formats/images/image_files.h"
#include "scene/error.h"
#include "values/lower_extension.h"
#include "values/srgb.h"

namespace vantage {
namespace {

/// Throws Error(input) with the first line of `reason`.
[[noreturn]] void fail(const std::filesystem::path& file, const std::string& reason) {
    throw Error(Exit::input, file.string() + ": " + reason.substr(0, reason.find('\n')));
}

/// Files of these formats hold linear light; others say so where they do (PNG by its gamma).
bool is_linear(const OIIO::ImageSpec& spec, const std::string& format) {
    return format == "openexr" || format == "hdr" || spec.get_string_attribute("oiio:ColorSpace") == "Linear";
}

/// Says what to do about a format that needs a library of its own.
[[noreturn]] void fail_to_open(const std::filesystem::path& file, const std::string& reason) {
    const std::string extension = lower_extension(file);
    const bool heic = extension == ".heic" || extension == ".heif" || extension == ".avif";
    fail(file,
         heic ? "not a readable photo; HEIC and AVIF need OpenImageIO with libheif and its decoders (package "
                "libheif1), or convert the photos to JPEG (heif-convert of libheif-examples): " +
                    reason
              : "not a readable photo: " + reason);
}

PhotoHeader read_header(const std::filesystem::path& file) {
    const auto in = OIIO::ImageInput::open(file.string());
    if (!in) fail_to_open(file, OIIO::geterror());
    const OIIO::ImageSpec& spec = in->spec();
    PhotoHeader header{{spec.width, spec.height},
                       {},
                       spec.get_int_attribute("Orientation", 1),
                       is_linear(spec, in->format_name())};
    if (!spec.find_attribute("ICCProfile")) return header;
    header.profile = spec.get_string_attribute("ICCProfile:profile_description", "unnamed");
    if (header.profile.find("sRGB") != std::string::npos) header.profile.clear();
    return header;
}

/// Red, green, blue and alpha of any image: gray, gray with alpha, RGB, RGBA, or more channels.
OIIO::ImageBuf as_rgba(const OIIO::ImageBuf& image) {
    const int n = image.spec().nchannels;  // -1: filled with a constant
    const int order[] = {0, n >= 3 ? 1 : 0, n >= 3 ? 2 : 0, n == 2 ? 1 : n >= 4 ? 3 : -1};
    const float fill[] = {0, 0, 0, 1};
    return OIIO::ImageBufAlgo::channels(image, 4, order, fill);
}

/// Linear light as sRGB bytes, clamped; alpha is linear in both. NaN becomes 0.
std::vector<std::uint8_t> srgb_bytes(const std::vector<float>& rgba) {
    std::vector<std::uint8_t> out(rgba.size());
    for (std::size_t i = 0; i < rgba.size(); ++i) {
        const float v = rgba[i] > 0 ? std::min(rgba[i], 1.0f) : 0.0f;
        out[i] = std::uint8_t(std::lround(255 * (i % 4 == 3 ? double(v) : srgb_from_linear(v))));
    }
    return out;
}

RgbaImage read(const std::filesystem::path& file) {
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    OIIO::ImageBuf image(file.string(), 0, 0, nullptr, &config);
    const bool linear = is_linear(image.spec(), image.file_format_name());
    if (!image.read(0, 0, true, linear ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8))
        fail(file, "cannot read: " + image.geterror());
    const OIIO::ImageBuf rgba = as_rgba(image);
    RgbaImage photo = blank_image(image.spec().width, image.spec().height);
    std::vector<float> light(linear ? photo.rgba.size() : 0);
    const bool read = linear ? rgba.get_pixels(rgba.roi(), OIIO::TypeDesc::FLOAT, light.data())
                             : rgba.get_pixels(rgba.roi(), OIIO::TypeDesc::UINT8, photo.rgba.data());
    if (!read) fail(file, "cannot read: " + rgba.geterror());
    if (linear) photo.rgba = srgb_bytes(light);
    return photo;
}

void write(const std::filesystem::path& file, int width, int height, int channels, Sample sample,
           std::span<const std::byte> pixels) {
    const auto type = sample == Sample::u8 ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT;
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

}  // namespace

extern "C" const ImageFiles vantage_image_files;
const ImageFiles vantage_image_files{read_header, read, write};

}  // namespace vantage
