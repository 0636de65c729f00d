// Distances to outlines are accurate to a tenth of a texel although they are computed only from coverage.
#include "player/panels/outline_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

using namespace vantage;

namespace {

constexpr int size = 40;
constexpr float most = 6;

/// The largest difference from the exact distance at positions up to `within` from the picture's center,
/// which is their origin. The coverage is sampled at 16 * 16 positions per texel.
double largest_error(const std::function<double(double, double)>& exact, double within = size) {
    std::vector<std::uint8_t> coverage;
    const auto middle = [](int texel) { return texel + 0.5 - size / 2.0; };
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            int inside = 0;
            for (int i = 0; i < 256; ++i)
                inside +=
                    exact(middle(x) + (i % 16 + 0.5) / 16 - 0.5, middle(y) + (i / 16 + 0.5) / 16 - 0.5) > 0;
            coverage.push_back(std::uint8_t(std::lround(inside * 255 / 256.0)));
        }
    const std::vector<float> distances = outline_distances(coverage, size, size, most);
    double worst = 0;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            if (std::hypot(middle(x), middle(y)) > within) continue;
            const double d = std::clamp<double>(exact(middle(x), middle(y)), -most, most);
            worst = std::max(worst, std::abs(d - double(distances[std::size_t(y * size + x)])));
        }
    return worst;
}

}  // namespace

TEST(OutlineDistance, OfDiscsOfAnySizeAndPlace) {
    for (const double radius : {3.0, 5.3, 9.7})
        for (const double off : {0.0, 0.21, 0.5})
            EXPECT_LT(largest_error(
                          [&](double x, double y) { return radius - std::hypot(x - off, y - 0.3 * off); }),
                      0.1)
                << radius << " " << off;
}

TEST(OutlineDistance, OfStrokesInAnyDirection) {
    for (const double width : {3.0, 4.3})
        for (int degrees = 0; degrees < 180; degrees += 15)
            for (const double off : {0.0, 0.3}) {
                const double a = degrees * std::numbers::pi / 180;
                const auto stroke = [&](double x, double y) {
                    const double across = x * std::sin(a) - y * std::cos(a) - off,
                                 along = x * std::cos(a) + y * std::sin(a);
                    return width / 2 - std::hypot(across, std::max(std::abs(along) - 10, 0.0));
                };
                // The stroke's round ends have a radius of less than two texels.
                EXPECT_LT(largest_error(stroke), 0.16) << width << " " << degrees << " " << off;
                EXPECT_LT(largest_error(stroke, 5), 0.05) << width << " " << degrees << " " << off;
            }
}

TEST(OutlineDistance, OfNothingIsTheLargest) {
    const std::vector<std::uint8_t> none(64, 0), all(64, 255);
    for (const float d : outline_distances(none, 8, 8, most)) EXPECT_EQ(d, -most);
    // Positions beyond the picture's edges are outside.
    const std::vector<float> distances = outline_distances(all, 8, 8, most);
    EXPECT_NEAR(distances.front(), 0.5f, 0.25f);
    EXPECT_NEAR(distances[3 * 8 + 3], 3.5f, 0.01f);
}
