// Tests distances to borders in degenerate images, and measures the error of jump flooding.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "base/gl/context.h"
#include "pipeline/stages/borders.h"
#include "pipeline/visibility/border_distance.h"
#include "pipeline/visibility/near_distance.h"
#include "tests/hard_cases/special_numbers.h"

using namespace vantage;

namespace {

struct Size {
    int width, height;
    std::size_t pixels() const { return std::size_t(width) * std::size_t(height); }
};

class DistanceTransform : public ::testing::Test {
  protected:
    const gl::HeadlessContext context{gl::Debug::on};
    const gl::Program jump_flood = jump_flood_program();

    struct Result {
        const char* method;
        std::vector<float> distance;
        bool exact;
    };
    /// The results of all methods.
    std::vector<Result> all(const std::vector<std::uint8_t>& borders, Size s) const {
        return {{"exact", exact_distance(borders, s.width, s.height), true},
                {"jump flooding", flood_distance(jump_flood, borders, s.width, s.height), false}};
    }
};

/// Distance to the nearest seed, by brute force.
float brute_force(const std::vector<std::array<int, 2>>& seeds, int x, int y) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& [u, v] : seeds) nearest = std::min(nearest, std::hypot(u - x, v - y));
    return float(nearest);
}

std::vector<std::uint8_t> seeded(Size s, const std::vector<std::array<int, 2>>& seeds) {
    std::vector<std::uint8_t> out(s.pixels(), 0);
    for (const auto& [x, y] : seeds) out[std::size_t(y) * std::size_t(s.width) + std::size_t(x)] = 1;
    return out;
}

constexpr Size sizes[] = {{1, 1}, {1, 97}, {97, 1}, {2, 2}, {61, 47}, {64, 64}, {65, 33}, {127, 129}};

}  // namespace

TEST_F(DistanceTransform, NoBorderIsInfiniteAndAllBorderIsZero) {
    for (const Size s : sizes)
        for (const bool only : {false, true})
            for (const Result& r : all(std::vector<std::uint8_t>(s.pixels(), only), s))
                for (const float d : r.distance)
                    ASSERT_EQ(d, only ? 0 : float(infinite)) << r.method << ' ' << s.width << 'x' << s.height;
}

TEST_F(DistanceTransform, SingleSeedInACornerMatchesTheClosedForm) {
    for (const Size s : sizes)
        for (const int x : {0, s.width - 1})
            for (const int y : {0, s.height - 1}) {
                const std::vector<std::array<int, 2>> seed{{x, y}};
                for (const Result& r : all(seeded(s, seed), s))  // flooding is exact for one seed
                    for (int v = 0; v < s.height; ++v)
                        for (int u = 0; u < s.width; ++u)
                            ASSERT_NEAR(r.distance[std::size_t(v) * std::size_t(s.width) + std::size_t(u)],
                                        brute_force(seed, u, v), 1e-3)
                                << r.method << ' ' << s.width << 'x' << s.height << " from " << x << ',' << y;
            }
}

TEST_F(DistanceTransform, WidestTexture) {
    const Size s{16384, 3};
    const std::vector<std::array<int, 2>> seeds{{0, 0}, {16383, 2}};
    for (const Result& r : all(seeded(s, seeds), s)) {
        std::size_t wrong = 0;
        for (int y = 0; y < s.height; ++y)
            for (int x = 0; x < s.width; ++x) {
                const float truth = brute_force(seeds, x, y),
                            d = r.distance[std::size_t(y) * std::size_t(s.width) + std::size_t(x)];
                ASSERT_TRUE(std::isfinite(d)) << r.method;
                wrong += std::abs(d - truth) > 1e-6f * truth + 1e-3f;
            }
        EXPECT_EQ(wrong, 0u) << r.method;
    }
}

TEST_F(DistanceTransform, AnySeedsMatchBruteForce) {
    EXPECT_TRUE(rc::check([&] {
        const Size s{*rc::gen::inRange(1, 40).as("width"), *rc::gen::inRange(1, 40).as("height")};
        const auto seed = rc::gen::apply(
            [](int x, int y) {
                return std::array<int, 2>{x, y};
            },
            rc::gen::inRange(0, s.width), rc::gen::inRange(0, s.height));
        const auto seeds = *rc::gen::container<std::vector<std::array<int, 2>>>(seed).as("seeds");
        for (const Result& r : all(seeded(s, seeds), s))
            for (int y = 0; y < s.height; ++y)
                for (int x = 0; x < s.width; ++x) {
                    const float truth = brute_force(seeds, x, y),
                                d = r.distance[std::size_t(y) * std::size_t(s.width) + std::size_t(x)];
                    RC_ASSERT(d >= truth - 1e-3f);
                    RC_ASSERT(d <= truth + (r.exact ? 1e-3f : 2.0f));
                }
    }));
}

// Flooding may miss the nearest seed and find one slightly farther away (Cuisenaire and Macq 1999; Rong and
// Tan 2006). No bound is known, so the error is measured.
TEST_F(DistanceTransform, FloodingErrorsAreRareAndSmall) {
    std::mt19937 random(5);
    double worst = 0;
    std::size_t wrong = 0, pixels = 0;
    for (int trial = 0; trial < 24; ++trial) {
        const Size s{60 + int(random() % 100), 40 + int(random() % 90)};
        std::vector<std::array<int, 2>> seeds;
        for (int i = 0; i < 3 + trial * trial; ++i)
            seeds.push_back({int(random() % unsigned(s.width)), int(random() % unsigned(s.height))});
        const auto d = flood_distance(jump_flood, seeded(s, seeds), s.width, s.height);
        for (int y = 0; y < s.height; ++y)
            for (int x = 0; x < s.width; ++x, ++pixels) {
                const float truth = brute_force(seeds, x, y),
                            off = d[std::size_t(y) * std::size_t(s.width) + std::size_t(x)] - truth;
                ASSERT_GE(off, -1e-3f) << "jump flooding found a distance smaller than that of any seed";
                worst = std::max(worst, double(off));
                wrong += off > 1e-3f;
            }
    }
    std::printf("wrong at %.4f %% of the pixels, by %.2f px at most\n", 100 * double(wrong) / double(pixels),
                worst);
    EXPECT_LT(worst, 2);
    EXPECT_LT(double(wrong), 0.005 * double(pixels));
}

TEST_F(DistanceTransform, WeightIsNearlyZeroOnTheOutlineAtAllSizes) {
    for (const Size s : sizes) {
        const auto weights =
            border_weights(exact_distance(std::vector<std::uint8_t>(s.pixels(), 0), s.width, s.height),
                           s.width, s.height, 64);
        for (int x = 0; x < s.width; ++x) EXPECT_LE(weights[std::size_t(x)], 2) << "half a pixel of 64";
        const auto near = near_distance(std::vector<std::uint8_t>(s.pixels(), 0), s.width, s.height, 16);
        for (const float d : near) EXPECT_TRUE(std::isinf(d));
    }
}
