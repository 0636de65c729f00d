#pragma once
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "scene/remote/byte_range.h"

namespace vantage {

/// Bytes per block. A block is the unit in which a remote file is fetched, cached and freed. The last block
/// of a file may be shorter.
inline constexpr std::uint64_t block_bytes = 64 << 10;

/// The blocks from `begin` up to, but not including, `end`.
struct BlockRun {
    std::uint64_t begin = 0, end = 0;
    std::uint64_t size() const { return end - begin; }
    bool operator==(const BlockRun&) const = default;
};

inline std::uint64_t number_of_blocks(std::uint64_t file_bytes) {
    return file_bytes / block_bytes + (file_bytes % block_bytes != 0);
}

/// The blocks that contain these bytes.
inline BlockRun blocks_of(ByteRange range) {
    if (range.begin >= range.end) return {};
    return {range.begin / block_bytes, (range.end - 1) / block_bytes + 1};
}

/// The blocks that contain the bytes of several ranges: sorted runs, which are merged where they touch.
inline std::vector<BlockRun> blocks_of(std::span<const ByteRange> ranges) {
    std::vector<BlockRun> runs, joined;
    for (const ByteRange& range : ranges)
        if (range.begin < range.end) runs.push_back(blocks_of(range));
    std::ranges::sort(runs, {}, &BlockRun::begin);
    for (const BlockRun& run : runs) {
        if (joined.empty() || joined.back().end < run.begin)
            joined.push_back(run);
        else
            joined.back().end = std::max(joined.back().end, run.end);
    }
    return joined;
}

/// The bytes of the blocks in a file of `file_bytes` bytes.
inline ByteRange bytes_of(BlockRun run, std::uint64_t file_bytes) {
    return {run.begin * block_bytes, std::min(run.end * block_bytes, file_bytes)};
}

}  // namespace vantage
