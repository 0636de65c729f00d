#pragma once
#include <cstdint>

namespace vantage {

/// The total work of a TileStream's threads since the package was opened.
struct StreamedSoFar {
    std::uint64_t bytes = 0;  ///< read from the package
    double seconds = 0;       ///< time spent on reading and decoding, summed over all threads

    StreamedSoFar operator+(const StreamedSoFar& o) const { return {bytes + o.bytes, seconds + o.seconds}; }
    StreamedSoFar operator-(const StreamedSoFar& o) const { return {bytes - o.bytes, seconds - o.seconds}; }
};

}  // namespace vantage
