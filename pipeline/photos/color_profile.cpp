#include "pipeline/photos/color_profile.h"

#include <lcms2.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <mutex>
#include <utility>

#include "pipeline/photos/light_table.h"

namespace vantage {
namespace {

/// A profile that changes no value (of 255) by more than this is treated as sRGB. Copies of the sRGB profile
/// change values by 1 because of rounding.
constexpr int srgb_tolerance = 2;
/// The same tolerance for profiles named sRGB, some of which simplify its curve to a gamma of 2.2, with
/// errors of 8 in dark values.
constexpr int named_srgb_tolerance = 16;

using Profile = std::unique_ptr<void, decltype(&cmsCloseProfile)>;
using Transform = std::shared_ptr<void>;

std::string description_of(const Profile& profile) {
    std::array<char, 128> text{};
    cmsGetProfileInfoASCII(profile.get(), cmsInfoDescription, "en", "US", text.data(), text.size());
    std::string name = text.data();
    std::erase_if(name, [](char c) { return c < ' ' || c > '~'; });
    return name;
}

Profile srgb_profile() { return {cmsCreate_sRGBProfile(), cmsCloseProfile}; }

/// Linear light with sRGB's primaries.
Profile light_profile() {
    const cmsCIExyY d65{0.3127, 0.3290, 1};
    const cmsCIExyYTRIPLE primaries{{0.64, 0.33, 1}, {0.30, 0.60, 1}, {0.15, 0.06, 1}};
    const std::unique_ptr<cmsToneCurve, decltype(&cmsFreeToneCurve)> identity(cmsBuildGamma(nullptr, 1),
                                                                              cmsFreeToneCurve);
    const std::array curves{identity.get(), identity.get(), identity.get()};
    return {cmsCreateRGBProfile(&d65, &primaries, curves.data()), cmsCloseProfile};
}

/// The transform from one profile to another; null if a profile is incomplete. With optimization, Little CMS
/// interpolates in a grid of colors, with errors of up to 28 of 255 near the limits of sRGB.
Transform transform(const Profile& from, cmsUInt32Number from_type, const Profile& to,
                    cmsUInt32Number to_type, cmsUInt32Number flags = 0) {
    cmsHTRANSFORM made =
        cmsCreateTransform(from.get(), from_type, to.get(), to_type, INTENT_RELATIVE_COLORIMETRIC,
                           flags | cmsFLAGS_BLACKPOINTCOMPENSATION | cmsFLAGS_NOOPTIMIZE | cmsFLAGS_NOCACHE);
    return made ? Transform(made, cmsDeleteTransform) : nullptr;
}

/// Transforms four-channel pixels. `to` may be the same memory as `from`.
template <class T>
void apply(const Transform& transform, std::span<const T> from, std::span<std::uint8_t> to) {
    cmsDoTransform(transform.get(), from.data(), to.data(), cmsUInt32Number(from.size() / 4));
}

/// The largest change of a value (of 255) by an RGB-to-RGB transform, over a grid of colors.
int change_of_colors(const Transform& bytes) {
    int most = 0;
    for (int r = 0; r < 256; r += 15)
        for (int g = 0; g < 256; g += 15)
            for (int b = 0; b < 256; b += 15) {
                const std::array from{std::uint8_t(r), std::uint8_t(g), std::uint8_t(b)};
                std::array<std::uint8_t, 3> to{};
                cmsDoTransform(bytes.get(), from.data(), to.data(), 1);
                for (std::size_t c = 0; c < 3; ++c) most = std::max(most, std::abs(to[c] - from[c]));
            }
    return most;
}

/// The largest change of a value by a gray-to-RGB transform, over all grays.
int change_of_grays(const Transform& bytes) {
    int most = 0;
    for (int v = 0; v < 256; ++v) {
        const auto from = std::uint8_t(v);
        std::array<std::uint8_t, 3> to{};
        cmsDoTransform(bytes.get(), &from, to.data(), 1);
        most = std::max(most, std::abs(to[1] - v));
    }
    return most;
}

/// Whether the profile converts colors with a table instead of curves and a matrix.
bool has_table(const Profile& profile) {
    const auto tables = {cmsSigAToB0Tag, cmsSigAToB1Tag, cmsSigDToB1Tag};
    return std::ranges::any_of(tables, [&](cmsTagSignature tag) { return cmsIsTag(profile.get(), tag); });
}

/// The light of each value of `channel` while the other channels are 0.
std::vector<Light> light_along(std::size_t channel, std::size_t channels, const Transform& to_light) {
    std::vector<float> from(channels * channel_values), to(3 * channel_values);
    for (std::size_t v = 0; v < channel_values; ++v)
        from[channels * v + channel] = float(v) / float(channel_values - 1);
    cmsDoTransform(to_light.get(), from.data(), to.data(), cmsUInt32Number(channel_values));
    std::vector<Light> light(channel_values);
    for (std::size_t v = 0; v < channel_values; ++v) std::copy_n(&to[3 * v], 3, light[v].begin());
    return light;
}

LightTable light_of_colors(const Transform& to_light) {
    LightTable light;
    for (std::size_t c = 0; c < 3; ++c) light[c] = light_along(c, 3, to_light);
    // Each channel's table includes the light of black, which must be added only once.
    const Light black = light[0][0];
    for (std::size_t c = 1; c < 3; ++c)
        for (Light& l : light[c])
            for (std::size_t i = 0; i < 3; ++i) l[i] -= black[i];
    return light;
}

/// The table for gray pixels: the red channel carries all the light, because green and blue repeat it.
LightTable light_of_grays(const Transform& to_light) {
    LightTable light{light_along(0, 1, to_light), std::vector<Light>(channel_values),
                     std::vector<Light>(channel_values)};
    for (Light& l : light[0]) l.fill(l[1]);  // the others differ only by rounding
    return light;
}

void convert_by_light(LightTable table, ColorProfile& out) {
    const auto light = std::make_shared<const LightTable>(std::move(table));
    out.convert = [light](std::span<std::uint8_t> pixels) { to_srgb(*light, pixels); };
    out.converted = [light](std::span<const std::uint16_t> pixels) { return to_srgb(*light, pixels); };
}

// The following three functions fill in the conversions unless the profile counts as sRGB because it changes
// colors by at most `tolerance`; they return false if the profile is incomplete.

bool set_colors(const Profile& profile, int tolerance, ColorProfile& out) {
    const Transform rgb = transform(profile, TYPE_RGB_8, srgb_profile(), TYPE_RGB_8),
                    light = transform(profile, TYPE_RGB_FLT, light_profile(), TYPE_RGB_FLT),
                    bytes = transform(profile, TYPE_RGBA_8, srgb_profile(), TYPE_RGBA_8),
                    words =
                        transform(profile, TYPE_RGBA_16, srgb_profile(), TYPE_RGBA_8, cmsFLAGS_COPY_ALPHA);
    if (!rgb || !light || !bytes || !words) return false;
    if (change_of_colors(rgb) <= tolerance) return true;
    if (!has_table(profile)) {
        convert_by_light(light_of_colors(light), out);
        return true;
    }
    out.convert = [bytes](std::span<std::uint8_t> pixels) { apply<std::uint8_t>(bytes, pixels, pixels); };
    out.converted = [words](std::span<const std::uint16_t> pixels) {
        std::vector<std::uint8_t> rgba(pixels.size());
        apply<std::uint16_t>(words, pixels, rgba);
        return rgba;
    };
    return true;
}

bool set_grays(const Profile& profile, int tolerance, ColorProfile& out) {
    const Transform gray = transform(profile, TYPE_GRAY_8, srgb_profile(), TYPE_RGB_8),
                    light = transform(profile, TYPE_GRAY_FLT, light_profile(), TYPE_RGB_FLT);
    if (!gray || !light) return false;
    if (change_of_grays(gray) > tolerance) convert_by_light(light_of_grays(light), out);
    return true;
}

bool set_inks(const Profile& profile, ColorProfile& out) {
    const Transform inks = transform(profile, TYPE_CMYK_8_REV, srgb_profile(), TYPE_RGBA_8);
    if (!inks) return false;
    out.convert = [inks](std::span<std::uint8_t> pixels) {
        apply<std::uint8_t>(inks, pixels, pixels);
        for (std::size_t i = 3; i < pixels.size(); i += 4) pixels[i] = 255;
    };
    return true;
}

const char* name_of(PixelColors colors) {
    return colors == PixelColors::gray ? "gray" : colors == PixelColors::rgb ? "RGB" : "CMYK";
}

ColorProfile read_profile(std::span<const std::byte> icc, PixelColors colors) {
    const Profile profile(cmsOpenProfileFromMem(icc.data(), cmsUInt32Number(icc.size())), cmsCloseProfile);
    if (!profile) return {{.flaw = "it is damaged"}};
    ColorProfile out{{.name = description_of(profile)}};
    const bool named_srgb = out.use.name.find("sRGB") != out.use.name.npos;
    const int tolerance = named_srgb ? named_srgb_tolerance : srgb_tolerance;
    const cmsColorSpaceSignature space = cmsGetColorSpace(profile.get());
    bool complete = true;
    if (space == cmsSigRgbData && colors != PixelColors::cmyk)
        complete = set_colors(profile, tolerance, out);
    else if (space == cmsSigGrayData && colors == PixelColors::gray)
        complete = set_grays(profile, tolerance, out);
    else if (space == cmsSigCmykData && colors == PixelColors::cmyk)
        complete = set_inks(profile, out);
    else
        out.use.flaw = std::string("it is not for ") + name_of(colors);
    if (!complete) out.use.flaw = "it is incomplete";
    out.use.converts = bool(out.convert);
    return out;
}

}  // namespace

std::shared_ptr<const ColorProfile> color_profile(std::span<const std::byte> icc, PixelColors colors) {
    // The photos of a scan usually share few profiles; some programs write a different one into each photo.
    constexpr std::size_t most = 8;
    static std::mutex mutex;
    static std::map<std::pair<PixelColors, std::vector<std::byte>>, std::shared_ptr<const ColorProfile>>
        known;
    const std::pair key(colors, std::vector<std::byte>(icc.begin(), icc.end()));
    const std::scoped_lock lock(mutex);
    if (const auto found = known.find(key); found != known.end()) return found->second;
    if (known.size() == most) known.clear();
    return known[key] = std::make_shared<const ColorProfile>(read_profile(icc, colors));
}

}  // namespace vantage
