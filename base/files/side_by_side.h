#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vantage {

/// Amplification of differences in side_by_side, to make small ones visible.
inline constexpr int shown_gain = 8;

/// Two RGBA8 pictures of the same size and `shown_gain` times the absolute difference of their colors
/// (opaque), from left to right: a picture of 3 * width pixels per row.
std::vector<std::uint8_t> side_by_side(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b,
                                       std::size_t width);

}  // namespace vantage
