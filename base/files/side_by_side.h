#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vantage {

/// The factor by which side_by_side amplifies differences, so that small ones are visible.
inline constexpr int shown_gain = 8;

/// Places two RGBA8 pictures of the same size and their difference side by side, in a picture that is 3 *
/// width pixels wide. The difference is opaque: the absolute difference of the colors times `shown_gain`.
std::vector<std::uint8_t> side_by_side(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b,
                                       std::size_t width);

}  // namespace vantage
