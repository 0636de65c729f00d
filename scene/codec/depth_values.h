#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vantage::codec {

/// Depth is stored with this many significant bits. The error is at most 2^-12 z, a sixteenth of the smallest
/// tolerance of depth comparisons in the shaders (depth_slack in shaders/contract.glsl).
inline constexpr int depth_bits = 12;
inline constexpr double depth_error = 1.0 / (1 << depth_bits);  ///< largest error, relative

/// Depth of width x height texels, f32: positive or +inf. Each is rounded to depth_bits significant bits,
/// halves upward; its remaining IEEE 754 bits, shifted to the right, are a number q. Texels become q - least
/// q + 1, or 0 for +inf, and then folded differences from the median prediction. One zstd frame: u32 least q;
/// the low bytes of all differences; their high bytes. Empty if the depths differ by more than 2^16 steps (a
/// factor of 4 billion) or are not positive; they must then be stored raw.
std::vector<std::byte> encode_depth(std::span<const std::byte> texels, int width, int height);

/// Decodes the depth. False if the bytes are damaged; the content of `texels` is then unspecified.
bool decode_depth(std::span<const std::byte> coded, int width, int height, std::span<std::byte> texels);

/// The depth after encoding and decoding.
float kept_depth(float z);

}  // namespace vantage::codec
