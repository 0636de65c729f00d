#include "player/plan/selection/photo_cover.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "tests/player/test_scene.h"

using namespace vantage;

TEST(PhotoCover, LeavesAlmostNothingUncovered) {
    Random random;
    for (int trial = 0; trial < 50; ++trial) {
        const int triangles = 300, sets = 12;
        std::vector<std::vector<std::uint64_t>> whole(sets, std::vector<std::uint64_t>(5, 0)), part = whole;
        for (int s = 0; s < sets; ++s) {
            const int first = int(random(0, 250)), last = first + int(random(1, 80));
            for (int t = first; t < std::min(last, triangles); ++t) {
                part[std::size_t(s)][std::size_t(t / 64)] |= std::uint64_t(1) << (t % 64);
                if (t > first) whole[std::size_t(s)][std::size_t(t / 64)] |= std::uint64_t(1) << (t % 64);
            }
        }
        CoverProblem problem;
        for (std::uint32_t f = 0; f < 300; f += 60) problem.runs.push_back({f, 60, random(0.5, 2)});
        for (std::size_t s = 0; s < sets; ++s) problem.sets.push_back({whole[s], part[s], random(0.1, 1)});
        const auto chosen = cover(problem);
        EXPECT_LE(uncovered_share(problem, chosen), 1.6e-3);
        EXPECT_EQ(std::set(chosen.begin(), chosen.end()).size(), chosen.size());
        for (std::size_t i = 0; i < chosen.size(); ++i) {
            auto fewer = chosen;
            fewer.erase(fewer.begin() + std::ptrdiff_t(i));
            EXPECT_GT(uncovered_share(problem, fewer), 1.6e-3) << "a chosen photo is redundant";
        }
    }
    EXPECT_TRUE(cover({}).empty());
    EXPECT_EQ(uncovered_share({}, {}), 0);
}
