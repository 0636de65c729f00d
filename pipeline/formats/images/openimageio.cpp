// The library that image_files() loads.
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

#include "pipeline/formats/images/image_files.h"
#include "scene/error.h"

namespace vantage {
namespace {

/// Throws Error(input) with the first line of `reason`.
[[noreturn]] void fail(const std::filesystem::path& file, const std::string& reason) {
    throw Error(Exit::input, file.string() + ": " + reason.substr(0, reason.find('\n')));
}

PhotoHeader read_header(const std::filesystem::path& file) {
    const auto in = OIIO::ImageInput::open(file.string());
    if (!in) fail(file, "not a readable photo: " + OIIO::geterror());
    const OIIO::ImageSpec& spec = in->spec();
    PhotoHeader header{{spec.width, spec.height}, {}, spec.get_int_attribute("Orientation", 1)};
    if (!spec.find_attribute("ICCProfile")) return header;
    header.profile = spec.get_string_attribute("ICCProfile:profile_description", "unnamed");
    if (header.profile.find("sRGB") != std::string::npos) header.profile.clear();
    return header;
}

RgbaImage read(const std::filesystem::path& file) {
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    OIIO::ImageBuf image(file.string(), 0, 0, nullptr, &config);
    if (!image.read(0, 0, true, OIIO::TypeDesc::UINT8)) fail(file, "cannot read: " + image.geterror());
    const OIIO::ImageSpec& spec = image.spec();
    // Source channels for gray, gray with alpha, RGB, RGBA; -1: filled with a constant.
    const int n = spec.nchannels;
    const int order[] = {0, n >= 3 ? 1 : 0, n >= 3 ? 2 : 0, n == 2 ? 1 : n >= 4 ? 3 : -1};
    const float fill[] = {0, 0, 0, 1};
    const OIIO::ImageBuf rgba = OIIO::ImageBufAlgo::channels(image, 4, order, fill);
    RgbaImage photo = blank_image(spec.width, spec.height);
    if (!rgba.get_pixels(rgba.roi(), OIIO::TypeDesc::UINT8, photo.rgba.data()))
        fail(file, "cannot read: " + rgba.geterror());
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
