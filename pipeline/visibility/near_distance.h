#pragma once
#include <cstdint>
#include <vector>

namespace vantage {

/// Largest reach of near_distance, in pixels: up to this reach, sums of two squares fit in 16 bits.
inline constexpr int max_near_distance = 120;

/// Exact Euclidean distance in pixels to the center of the nearest border pixel; +inf beyond `reach`, which
/// is clamped to [0, max_near_distance]. The transform is separable, columns before rows (Saito and Toriwaki
/// 1994); the bound makes it several times faster than an unbounded one.
std::vector<float> near_distance(const std::vector<std::uint8_t>& borders, int width, int height, int reach);

}  // namespace vantage
