#include "base/values/main_box.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace vantage {
namespace {

using Points = std::vector<Eigen::Vector3d>;

/// The strays, computed from their definition with sorted coordinates and distances.
std::vector<std::uint32_t> strays_by_definition(const Points& points) {
    const std::size_t n = points.size(), most = std::min(std::max<std::size_t>(3, n / 100), n / 4);
    Eigen::Vector3d median;
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double> x;
        for (const auto& p : points) x.push_back(p[axis]);
        std::ranges::sort(x);
        median[axis] = x[n / 2];
    }
    std::vector<double> distance;
    for (const auto& p : points) distance.push_back((p - median).cwiseAbs().maxCoeff());
    std::vector<double> sorted = distance;
    std::ranges::sort(sorted);
    std::vector<std::uint32_t> out;
    const double farthest_other = sorted[n - 1 - most];
    for (std::uint32_t v = 0; v < n; ++v)
        if (farthest_other > 0 && distance[v] > 20 * farthest_other) out.push_back(v);
    return out;
}

TEST(MainBox, FindsTheStraysOfItsDefinition) {
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform;
    std::size_t with_strays = 0, without = 0;
    for (int round = 0; round < 3000; ++round) {
        const auto n = std::size_t(1 + 400 * std::pow(uniform(random), 3));
        // The distributions range from a cluster at one end to clusters at both ends. The number of vertices
        // far away is up to twice the number that may be treated as strays.
        const double skew = 4 * uniform(random), far = std::pow(10.0, 3 * uniform(random));
        Points points;
        for (std::size_t i = 0; i < n; ++i)
            points.emplace_back(std::pow(uniform(random), skew), 0.3 * normal(random), uniform(random));
        const auto distant = std::size_t(uniform(random) * double(std::max<std::size_t>(8, n / 50)));
        for (std::size_t i = 0; i < std::min(distant, n); ++i)
            points[random() % n] *= far * (uniform(random) < 0.5 ? -1 : 1);
        const std::vector<std::uint32_t> expected = strays_by_definition(points);
        EXPECT_EQ(main_box(points, {}).strays, expected) << n << " points, " << distant << " far";
        ++(expected.empty() ? without : with_strays);
    }
    EXPECT_GT(with_strays, 300u);
    EXPECT_GT(without, 300u);
}

}  // namespace
}  // namespace vantage
