#pragma once
#include <cstddef>
#include <span>
#include <vector>

namespace vantage {

/// A chunk of Form::zstd with this content: its length, a frame, and zeros if that is very short. Empty if it
/// is not shorter than the content.
std::vector<std::byte> zstd_chunk(std::span<const std::byte> content);
/// The content of such a chunk of at least 8 bytes; empty if it is damaged.
std::vector<std::byte> content_of_zstd(std::span<const std::byte> chunk);

}  // namespace vantage
