#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vantage::codec {

/// Texels of four bytes (color with alpha, or weight maps), without loss. Each of the four planes is either
/// one value or the differences from its median prediction, modulo 256; all of that is one zstd frame: u8 per
/// plane, 1 if it has one value; then per plane that value, or width x height differences, folded. `texels`
/// holds width * height * 4 bytes.
std::vector<std::byte> encode_planes(std::span<const std::byte> texels, int width, int height);

/// False if the bytes are damaged; `texels` may then hold anything.
bool decode_planes(std::span<const std::byte> coded, int width, int height, std::span<std::byte> texels);

}  // namespace vantage::codec
