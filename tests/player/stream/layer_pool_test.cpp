#include "player/stream/layer_pool.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <vector>

#include "tests/player/test_scene.h"

using namespace vantage;

TEST(LayerPool, EvictsLeastRecentlyUsedButNothingInUse) {
    Random random;
    LayerPool pool(7, 40);
    std::vector<std::uint32_t> order;  // reference: most recent last
    std::vector<std::uint64_t> used(40, 0);
    for (std::uint64_t frame = 1; frame < 400; ++frame)
        for (int i = 0; i < 5; ++i) {
            const auto page = std::uint32_t(random(0, 39.99));
            const bool held = std::ranges::count(order, page) > 0;
            ASSERT_EQ(pool.layer_of(page).has_value(), held);
            if (held) {
                ASSERT_TRUE(pool.use(page, frame));
                std::erase(order, page);
            } else if (order.size() == 7) {
                if (used[order.front()] == frame) {
                    ASSERT_FALSE(pool.place(page, frame));
                    continue;
                }
                order.erase(order.begin());
                ASSERT_TRUE(pool.place(page, frame));
            } else {
                ASSERT_TRUE(pool.place(page, frame));
            }
            order.push_back(page);
            used[page] = frame;
            std::set<std::uint32_t> layers;
            for (const std::uint32_t p : order) layers.insert(*pool.layer_of(p));
            ASSERT_EQ(layers.size(), order.size()) << "two pages are in one layer";
            ASSERT_EQ(pool.available(frame),
                      7 - std::ranges::count_if(order, [&](auto p) { return used[p] == frame; }));
        }
}
