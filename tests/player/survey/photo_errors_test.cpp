#include "player/survey/photo_errors.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace vantage;

namespace {

package::PairRecord pair(std::uint32_t a, std::uint32_t b, float median, std::uint32_t matches) {
    package::PairRecord p{};
    p.a = a;
    p.b = b;
    p.median = median;
    p.matches = matches;
    return p;
}

}  // namespace

TEST(PhotoErrors, AreMediansOverPairsByTheirMatches) {
    // Photo 3 is inaccurate: it disagrees with the two others, which agree with each other.
    const std::vector pairs{pair(0, 1, 0.5f, 200), pair(0, 3, 4.0f, 100), pair(1, 3, 6.0f, 120),
                            pair(0, 0, 0.0f, 0)};
    const auto errors = photo_errors(pairs, 5);
    ASSERT_EQ(errors.size(), 5u);
    EXPECT_EQ(errors[0], 0.5);
    EXPECT_EQ(errors[1], 0.5);
    EXPECT_FALSE(errors[2]) << "in no pair";
    EXPECT_EQ(errors[3], 6.0);
    EXPECT_FALSE(errors[4]);
}

TEST(PhotoErrors, IgnorePairsThatSayNothing) {
    const std::vector pairs{pair(0, 7, 1.0f, 10), pair(1, 0, 1.0f, 10), pair(0, 1, NAN, 10),
                            pair(0, 1, 1.0f, 0)};
    for (const auto& error : photo_errors(pairs, 2)) EXPECT_FALSE(error);
    EXPECT_TRUE(photo_errors({}, 0).empty());
}
