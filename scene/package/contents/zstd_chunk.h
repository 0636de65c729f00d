#pragma once
#include <cstddef>
#include <span>
#include <vector>

namespace vantage {

/// Encodes content as a chunk of Form::zstd: its length, a frame, and zeros if the frame is very short. Empty
/// if the result is not shorter than the content.
std::vector<std::byte> zstd_chunk(std::span<const std::byte> content);
/// The content of such a chunk of at least 8 bytes; empty if it is damaged.
std::vector<std::byte> content_of_zstd(std::span<const std::byte> chunk);

}  // namespace vantage
