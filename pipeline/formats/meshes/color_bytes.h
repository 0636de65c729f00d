#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace vantage {

/// Vertex colors as bytes. `channels` are red, green, blue and alpha as a file stores them, each with a value
/// per vertex or empty; an empty alpha is opaque. The range follows from the largest value of red, green and
/// blue: up to 255 or up to 65535; real values up to 1 are fractions. The range of alpha follows from its own
/// values in the same way. NaN becomes 0.
std::vector<std::array<std::uint8_t, 4>> color_bytes(const std::array<std::vector<double>, 4>& channels,
                                                     bool is_real, bool is_alpha_real);

}  // namespace vantage
