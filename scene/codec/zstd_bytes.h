#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace vantage::codec {

inline constexpr int tile_effort = 3;  ///< zstd level for the content of tiles

/// Compresses the bytes to one zstd frame (RFC 8878). `level`: 1 to 19.
std::vector<std::byte> compress(std::span<const std::byte> bytes, int level);

/// Decompresses the frame at the beginning of `frame` to the beginning of `to` and returns the length of its
/// content. The result is empty if the frame is damaged or its content is longer than `to`. Memory use is
/// bounded by the size of `to`, whatever the frame claims.
std::optional<std::size_t> decompress_up_to(std::span<const std::byte> frame, std::span<std::byte> to);

/// Fills `to` with the content of a frame. Returns false if the frame is damaged or its content has a
/// different length.
bool decompress(std::span<const std::byte> frame, std::span<std::byte> to);

}  // namespace vantage::codec
