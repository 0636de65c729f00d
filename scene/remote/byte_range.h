#pragma once
#include <cstdint>

namespace vantage {

/// The bytes of a file from `begin` up to, but not including, `end`.
struct ByteRange {
    std::uint64_t begin = 0, end = 0;
    std::uint64_t size() const { return end - begin; }
    bool operator==(const ByteRange&) const = default;
};

}  // namespace vantage
