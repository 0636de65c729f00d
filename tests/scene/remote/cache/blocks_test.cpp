#include "scene/remote/cache/blocks.h"

#include <gtest/gtest.h>

namespace vantage {

TEST(Blocks, HoldTheBytes) {
    EXPECT_EQ(blocks_of({0, 1}), (BlockRun{0, 1}));
    EXPECT_EQ(blocks_of({block_bytes - 1, block_bytes + 1}), (BlockRun{0, 2}));
    EXPECT_EQ(blocks_of({block_bytes, 2 * block_bytes}), (BlockRun{1, 2}));
    EXPECT_EQ(blocks_of({7, 7}), (BlockRun{}));
    EXPECT_EQ(bytes_of({1, 2}, block_bytes + 5), (ByteRange{block_bytes, block_bytes + 5}));
    EXPECT_EQ(number_of_blocks(block_bytes + 1), 2);
    EXPECT_EQ(number_of_blocks(block_bytes), 1);
}

TEST(Blocks, AreJoinedWhereRangesOverlapOrTouch) {
    const std::vector<ByteRange> ranges = {{5 * block_bytes, 6 * block_bytes},
                                           {10, 20},
                                           {30, block_bytes + 1},
                                           {2 * block_bytes, 2 * block_bytes + 1},
                                           {9, 9}};
    EXPECT_EQ(blocks_of(ranges), (std::vector<BlockRun>{{0, 3}, {5, 6}}));
}

}  // namespace vantage
