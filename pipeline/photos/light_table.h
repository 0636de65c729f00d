#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vantage {

/// Linear light of sRGB, negative for colors outside it; the fourth value is unused.
using Light = std::array<float, 4>;

/// Number of values of a 16-bit channel.
inline constexpr std::size_t channel_values = 65536;

/// Light tables of profiles with curves and a matrix: a pixel's light is the sum of the table entries of its
/// red, green and blue values. Each of the three tables has `channel_values` elements.
using LightTable = std::array<std::vector<Light>, 3>;

/// Converts four-channel pixels to sRGB and clips them. NaN becomes 0, and alpha is unchanged.
void to_srgb(const LightTable& light, std::span<std::uint8_t> rgba);
/// Like the function above, but for 16 bits per channel, rounded to 8 afterwards.
std::vector<std::uint8_t> to_srgb(const LightTable& light, std::span<const std::uint16_t> rgba);

}  // namespace vantage
