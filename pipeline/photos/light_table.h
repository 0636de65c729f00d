#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vantage {

/// Linear light of sRGB, negative in colors outside it; the fourth value is not used.
using Light = std::array<float, 4>;

/// Values of 16 bits that each channel of a pixel may have.
inline constexpr std::size_t channel_values = 65536;

/// Colors that follow from curves and a matrix: a pixel's light is the sum of what its red, green and blue
/// values add. Each of the three has `channel_values` elements.
using LightTable = std::array<std::vector<Light>, 3>;

/// Converts pixels of four values each to sRGB, clipped; light that is NaN becomes 0, alpha stays.
void to_srgb(const LightTable& light, std::span<std::uint8_t> rgba);
/// The same of 16 bits per value, rounded to 8 afterwards.
std::vector<std::uint8_t> to_srgb(const LightTable& light, std::span<const std::uint16_t> rgba);

}  // namespace vantage
