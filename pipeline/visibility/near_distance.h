#pragma once
#include <cstdint>
#include <vector>

namespace vantage {

/// The farthest that near_distance looks, in pixels.
inline constexpr int farthest_near = 120;

/// Exact Euclidean distance in pixels to the nearest border pixel's centre, +inf where it is beyond `reach`
/// (at most farthest_near): separable, down the columns and then along the rows (Saito and Toriwaki 1994),
/// and bounded, which makes it several times as fast as a transform of the whole.
std::vector<float> near_distance(const std::vector<std::uint8_t>& borders, int width, int height, int reach);

}  // namespace vantage
