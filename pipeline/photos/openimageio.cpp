// The library that image_files() loads.
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/strutil.h>

#include <algorithm>
#include <cmath>

#include "base/text/error.h"
#include "base/text/lower_extension.h"
#include "base/values/srgb.h"
#include "pipeline/photos/heif_profile.h"
#include "pipeline/photos/image_files.h"
#include "pipeline/photos/tiff_flaw.h"

namespace vantage {
namespace {

/// Throws Error(input) with the first line of `reason`.
[[noreturn]] void fail(const std::filesystem::path& file, const std::string& reason) {
    throw Error(Exit::input, file.string() + ": " + reason.substr(0, reason.find('\n')));
}

/// Files of these formats contain linear light. Files of other formats state whether they do (PNG by its
/// gamma).
bool is_linear(const OIIO::ImageSpec& spec, const std::string& format) {
    return format == "openexr" || format == "hdr" ||
           OIIO::Strutil::iequals(spec.get_string_attribute("oiio:ColorSpace"), "linear");
}

/// The file's ICC profile; null if it has none.
std::shared_ptr<const ColorProfile> profile_of(const OIIO::ImageSpec& spec, const std::string& format,
                                               const std::filesystem::path& file) {
    std::vector<std::byte> icc;
    if (const OIIO::ParamValue* found = spec.find_attribute("ICCProfile")) {
        const auto* bytes = static_cast<const std::byte*>(found->data());
        icc.assign(bytes, bytes + found->datasize());
    } else if (format == "heif") {
        icc = heif_profile(file);
    }
    if (icc.empty()) return nullptr;
    return color_profile(icc, spec.nchannels < 3 ? PixelColors::gray : PixelColors::rgb);
}

bool is_tiff_of(const OIIO::ImageSpec& spec, const std::string& format, int photometric) {
    return format == "tiff" && spec.get_int_attribute("tiff:PhotometricInterpretation", -1) == photometric;
}

/// Throws Error(input) for files that OpenImageIO reads incorrectly.
void expect_readable(const OIIO::ImageSpec& spec, const std::string& format,
                     const std::filesystem::path& file) {
    if (format != "tiff") return;
    if (const std::string flaw = tiff_flaw(file); !flaw.empty()) fail(file, flaw);
    constexpr int separated = 5;  // TIFF's code for CMYK
    if (!is_tiff_of(spec, format, separated)) return;
    if (spec.tile_width > 0) fail(file, "its CMYK colors are in tiles, expected strips, or RGB");
    if (spec.nchannels < 3 || spec.channelnames[0] != "R")
        fail(file, "its inks are not exactly cyan, magenta, yellow and black; expected CMYK or RGB");
}

/// Throws Error(input); for formats that need an additional library, the message contains advice.
[[noreturn]] void fail_to_open(const std::filesystem::path& file, const std::string& reason) {
    const std::string extension = lower_extension(file);
    const bool heic = extension == ".heic" || extension == ".heif" || extension == ".avif";
    fail(file,
         heic ? "not a readable photo; HEIC and AVIF need OpenImageIO with libheif and its decoders (package "
                "libheif1); otherwise, convert the photos to JPEG (heif-convert of libheif-examples): " +
                    reason
              : "not a readable photo: " + reason);
}

/// Throws Error(input).
std::unique_ptr<OIIO::ImageInput> opened(const std::filesystem::path& file, const OIIO::ImageSpec& config) {
    auto in = OIIO::ImageInput::open(file.string(), &config);
    if (!in) fail_to_open(file, OIIO::geterror());
    return in;
}

PhotoHeader read_header(const std::filesystem::path& file) {
    const auto in = opened(file, {});
    const OIIO::ImageSpec& spec = in->spec();
    expect_readable(spec, in->format_name(), file);
    const auto profile = profile_of(spec, in->format_name(), file);
    const ProfileUse use = profile ? profile->use : ProfileUse{};
    const int orientation = spec.get_int_attribute("Orientation", 1);
    return {{spec.width, spec.height},
            use,
            orientation >= 1 && orientation <= 8 ? orientation : 1,
            !use.converts && is_linear(spec, in->format_name())};
}

/// Red, green, blue and alpha of any image: gray or RGB, with or without alpha, or with other channels.
/// `negative`: white is 0.
OIIO::ImageBuf as_rgba(const OIIO::ImageBuf& image, bool negative) {
    const int n = image.spec().nchannels;
    const int order[] = {0, n >= 3 ? 1 : 0, n >= 3 ? 2 : 0, image.spec().alpha_channel};  // -1: filled
    const float fill[] = {0, 0, 0, 1};
    OIIO::ImageBuf out = OIIO::ImageBufAlgo::channels(image, 4, order, fill);
    OIIO::ROI colors = out.roi();
    colors.chend = 3;
    if (negative) OIIO::ImageBufAlgo::invert(out, out, colors);
    return out;
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

/// Throws Error(input).
template <class T>
std::vector<T> values_of(const OIIO::ImageBuf& rgba, const std::filesystem::path& file) {
    std::vector<T> out(rgba.spec().image_pixels() * 4);
    if (!rgba.get_pixels(rgba.roi(), OIIO::BaseTypeFromC<T>::value, out.data()))
        fail(file, "cannot read: " + rgba.geterror());
    return out;
}

/// Whether all pixels are transparent.
bool is_clear(const RgbaImage& image) {
    for (std::size_t i = 3; i < image.rgba.size(); i += 4)
        if (image.rgba[i]) return false;
    return true;
}

/// Reads with a separate ImageInput: ImageBuf uses a cache shared by the whole process, which returns wrong
/// pixels or aborts if several threads read the same file at the same time. Uses one thread, because photos
/// are read in parallel.
RgbaImage read_with(bool profiles, const std::filesystem::path& file) {
    using OIIO::TypeDesc;
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    const auto in = opened(file, config);
    in->threads(1);
    OIIO::ImageSpec spec = in->spec();
    const std::string format = in->format_name();
    const auto profile = profiles ? profile_of(spec, format, file) : nullptr;
    const bool converts = profile && profile->use.converts;
    const bool linear = !converts && is_linear(spec, format);
    const bool words = converts && spec.format.size() > 1;
    expect_readable(spec, format, file);
    // OpenImageIO itself inverts values of 8 bits and fewer.
    const bool negative = is_tiff_of(spec, format, 0) && spec.format != TypeDesc::UINT8;
    spec.set_format(linear ? TypeDesc::FLOAT : words ? TypeDesc::UINT16 : TypeDesc::UINT8);
    OIIO::ImageBuf image(spec, OIIO::InitializePixels::No);
    if (!in->read_image(0, 0, 0, spec.nchannels, spec.format, image.localpixels()))
        fail(file, "cannot read: " + in->geterror());
    const auto bytes_of = [&](const OIIO::ImageBuf& rgba) {
        if (linear) return srgb_bytes(values_of<float>(rgba, file));
        if (words) return profile->converted(values_of<std::uint16_t>(rgba, file));
        std::vector<std::uint8_t> bytes = values_of<std::uint8_t>(rgba, file);
        if (converts) profile->convert(bytes);
        return bytes;
    };
    RgbaImage photo = blank_image(spec.width, spec.height);
    // Converts in batches of rows, so that the photo is in memory at most twice.
    constexpr int rows = 64;
    auto to = photo.rgba.begin();
    for (OIIO::ROI part = image.roi(); part.ybegin < image.roi().yend; part.ybegin += rows) {
        part.yend = std::min(part.ybegin + rows, image.roi().yend);
        to = std::ranges::copy(bytes_of(as_rgba(OIIO::ImageBufAlgo::cut(image, part), negative)), to).out;
    }
    // The fourth byte may be meaningless, but OpenImageIO has multiplied the colors by it.
    if (format == "bmp" && is_clear(photo))
        fail(file, "its pixels have 32 bits and no opacity, expected a BMP of 24 bits");
    return photo;
}

RgbaImage read(const std::filesystem::path& file) { return read_with(true, file); }
RgbaImage read_unprofiled(const std::filesystem::path& file) { return read_with(false, file); }

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
const ImageFiles vantage_image_files{read_header, read, read_unprofiled, write};

}  // namespace vantage
