#pragma once
#include <cstddef>
#include <span>
#include <vector>

namespace vantage::codec {

/// Encodes opaque RGBA pixels as a baseline JPEG with chroma at full resolution. `quality`: 1 to 100.
std::vector<std::byte> encode_jpeg(std::span<const std::byte> rgba, int width, int height, int quality);

/// Decodes a whole JPEG in the same way as photos (accurate inverse DCT, smooth chroma); alpha is 255.
/// Returns false if the JPEG is damaged or has a different size.
bool decode_jpeg(std::span<const std::byte> jpeg, int width, int height, std::span<std::byte> rgba);

}  // namespace vantage::codec
