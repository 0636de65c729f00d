#pragma once
#include <cstddef>
#include <span>

namespace vantage::codec {

constexpr int huffman_tables = 0xc4;  ///< the marker DHT

inline int byte_at(std::span<const std::byte> b, std::size_t i) { return std::to_integer<int>(b[i]); }
/// Big-endian.
inline int word_at(std::span<const std::byte> b, std::size_t i) {
    return byte_at(b, i) << 8 | byte_at(b, i + 1);
}

}  // namespace vantage::codec
