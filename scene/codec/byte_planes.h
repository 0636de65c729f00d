#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vantage::codec {

/// Lossless coding of four-byte texels (color with alpha, or weight maps). Each of the four planes is stored
/// as a single value or as differences, modulo 256, from its median prediction. All of this is one zstd
/// frame: for each plane, a u8 that is 1 if the plane has a single value; then, for each plane, that value or
/// width x height folded differences. `texels`: width * height * 4 bytes.
std::vector<std::byte> encode_planes(std::span<const std::byte> texels, int width, int height);

/// Decodes the texels. Returns false if the bytes are damaged; the content of `texels` is then unspecified.
bool decode_planes(std::span<const std::byte> coded, int width, int height, std::span<std::byte> texels);

}  // namespace vantage::codec
