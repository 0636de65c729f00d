#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vantage::codec {

/// The number of significant bits with which depth is stored. The error is at most 2^-12 z, a sixteenth of
/// the smallest tolerance of the depth comparisons in the shaders (depth_slack in shaders/contract.glsl).
inline constexpr int depth_bits = 12;
inline constexpr double depth_error = 1.0 / (1 << depth_bits);  ///< the largest relative error

/// Encodes the depths of width x height texels, each an f32 that is positive or +inf. A depth is rounded to
/// depth_bits significant bits, with halves rounded up. The remaining IEEE 754 bits, shifted to the right,
/// form a number q. A texel's value is q - least q + 1, or 0 for +inf, and is coded as the folded difference
/// from its median prediction. The result is one zstd frame: the least q as a u32, the low bytes of all
/// differences, and their high bytes. The result is empty if the depths differ by more than 2^16 steps (a
/// factor of 4 billion) or are not positive; they must then be stored raw.
std::vector<std::byte> encode_depth(std::span<const std::byte> texels, int width, int height);

/// Decodes the depth. Returns false if the bytes are damaged; the content of `texels` is then unspecified.
bool decode_depth(std::span<const std::byte> coded, int width, int height, std::span<std::byte> texels);

/// The value of a depth after encoding and decoding.
float kept_depth(float z);

}  // namespace vantage::codec
