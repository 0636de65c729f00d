#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace vantage {

/// The color model of a photo's pixels, apart from alpha.
enum class PixelColors { gray, rgb, cmyk };

/// The treatment of colors with an ICC profile.
struct ProfileUse {
    std::string name{};  ///< the profile's own description, in ASCII; may be empty
    /// The reason why the profile is ignored and colors are treated as sRGB; may be empty.
    std::string flaw{};
    /// Whether colors are converted to sRGB; false if they are sRGB or treated as such.
    bool converts = false;
};

/// The conversion from an ICC profile (ISO 15076-1) to sRGB: relative colorimetric with black point
/// compensation; colors outside sRGB are clipped. Thread-safe. `convert` and `converted` are empty unless
/// `use.converts` is set.
struct ColorProfile {
    ProfileUse use{};
    /// Converts four-channel pixels to RGBA. The channels are red, green and blue, which are equal if the
    /// photo is gray, and alpha, which is unchanged; or they are inks as Adobe stores them in JPEG files,
    /// with 255 for no ink.
    std::function<void(std::span<std::uint8_t> pixels)> convert{};
    /// Like `convert`, but for 16 bits per channel, rounded to 8 afterwards; empty for inks.
    std::function<std::vector<std::uint8_t>(std::span<const std::uint16_t> pixels)> converted{};
};

/// The profile of a photo with these colors; use.flaw reports invalid bytes. Each profile is created once for
/// all photos that share it. Thread-safe.
std::shared_ptr<const ColorProfile> color_profile(std::span<const std::byte> icc, PixelColors colors);

}  // namespace vantage
