#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vantage::codec {

/// Lossless coding of four-byte texels (color with alpha, or weight maps). Each of the four planes is stored
/// as a single value, or as differences from its median prediction, modulo 256. Everything is one zstd frame:
/// a u8 per plane, 1 if it has a single value; then per plane that value, or width x height folded
/// differences. `texels` holds width * height * 4 bytes.
std::vector<std::byte> encode_planes(std::span<const std::byte> texels, int width, int height);

/// Decodes the texels. False if the bytes are damaged; the content of `texels` is then unspecified.
bool decode_planes(std::span<const std::byte> coded, int width, int height, std::span<std::byte> texels);

}  // namespace vantage::codec
