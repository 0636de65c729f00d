#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vantage::codec {

/// Depth is kept with this many significant bits: an error of at most 2^-12 z, a sixteenth of the smallest
/// slack with which the shaders compare depths (depth_slack in shaders/contract.glsl).
inline constexpr int depth_bits = 12;
inline constexpr double depth_error = 1.0 / (1 << depth_bits);  ///< largest error, relative

/// Depth of width x height texels, f32: positive or +inf. Each is rounded to depth_bits significant bits,
/// halves upward; what remains of its IEEE 754 bits, shifted to the right, is a number q. Texels become q -
/// least q + 1, and 0 for +inf; then differences from the median prediction, folded. One zstd frame: u32
/// least q; the low bytes of all differences; their second bytes. Empty if the depths differ by more than
/// 2^16 steps (a factor of 4 billion) or are not positive: they have to be stored as they are.
std::vector<std::byte> encode_depth(std::span<const std::byte> texels, int width, int height);

/// False if the bytes are damaged; `texels` may then hold anything.
bool decode_depth(std::span<const std::byte> coded, int width, int height, std::span<std::byte> texels);

/// A depth as it is read back.
float kept_depth(float z);

}  // namespace vantage::codec
