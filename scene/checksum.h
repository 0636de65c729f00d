#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

namespace vantage {

/// XXH3-64 of the bytes, seed 0.
std::uint64_t checksum(std::span<const std::byte> bytes);

}  // namespace vantage
