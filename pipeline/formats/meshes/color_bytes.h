#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace vantage {

/// Vertex colors as bytes. `channels` are red, green, blue and alpha as a file stores them, each of which has
/// a value per vertex or is empty; an empty alpha is opaque. The largest value of red, green and blue
/// determines the range: 0 to 255 if it is at most 255, otherwise 0 to 65535; floating-point values up to 1
/// are fractions. The range of alpha is determined in the same way from its own values. NaN becomes 0.
std::vector<std::array<std::uint8_t, 4>> color_bytes(const std::array<std::vector<double>, 4>& channels,
                                                     bool is_real, bool is_alpha_real);

}  // namespace vantage
