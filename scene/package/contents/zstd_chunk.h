#pragma once
#include <cstddef>
#include <span>
#include <vector>

namespace vantage {

/// Encodes content as a chunk of Form::zstd: the length of the content, a frame, and zeros if the frame is
/// very short. Empty if the result is not shorter than the content.
std::vector<std::byte> zstd_chunk(std::span<const std::byte> content);
/// The content of a chunk of Form::zstd; empty if the chunk is damaged. The chunk must have at least 8 bytes.
std::vector<std::byte> content_of_zstd(std::span<const std::byte> chunk);

}  // namespace vantage
