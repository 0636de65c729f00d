#include "pipeline/background/photo_labels.h"

#include <gtest/gtest.h>

#include <cmath>

#include "pipeline/background/view_sample.h"
#include "tests/pipeline/background/yard.h"

using namespace vantage;

namespace {

/// Photos of the yard that are brighter or darker by up to a seventh each.
std::vector<CoarseView> unevenly_exposed() {
    std::vector<CoarseView> views = yard::photos();
    for (CoarseView& v : views) {
        const float gain = 1 + 0.07f * float(int(v.photo * 2 % 5) - 2);
        for (std::size_t at = 0; at < v.ln.size(); ++at)
            if (v.is_open(at)) v.ln[at] = ln_of(linear_of(v.ln[at]) * gain);
    }
    return views;
}

bool shows(const CoarseView& v, const Eigen::Vector3f& place) {
    return sample(v, in_camera(v, place), 1).kind == ViewSample::open;
}

}  // namespace

TEST(Sky, OfTheYardIsInfinitelyFar) {
    const std::vector<CoarseView> views = yard::photos();
    const Backdrop b = estimate_backdrop(views, {}, {}, 0);
    ASSERT_TRUE(b.sky.any());
    std::size_t sky = 0, far = 0, hill = 0, hill_far = 0;
    for (std::size_t d = 0; d < b.positions.size(); ++d) {
        const Eigen::Vector3d direction = b.sphere.directions[d].cast<double>();
        const double truth = yard::distance(b.center, direction);
        const bool is_far = (b.positions[d].cast<double>() - b.center).norm() > 1000;
        const Eigen::Vector3d place = b.center + std::min(truth, 1e6) * direction;
        if (std::ranges::count_if(views, [&](const auto& v) { return shows(v, place.cast<float>()); }) < 3)
            continue;
        if (std::isfinite(truth))
            ++hill, hill_far += is_far;
        else
            ++sky, far += is_far;
    }
    EXPECT_GT(double(far), 0.97 * double(sky));
    EXPECT_LT(double(hill_far), 0.02 * double(hill)) << "except along the outline against the sky";
}

TEST(Sky, IsNotSeenInAWallAround) {
    const auto views = yard::photos([](const auto& eye, const auto& ray, const auto&) {
        const Eigen::Vector3d p = eye + 12 * ray;
        return Eigen::Array3f(Eigen::Array3f(0.7f, 0.7f, 0.65f) *
                              float(yard::texture(6 * p.x() + 4 * p.y(), 7 * p.z())));
    });
    EXPECT_FALSE(estimate_backdrop(views, {}, {}, 0).sky.any());
}

TEST(PhotoLabels, AreOfPhotosThatShowThePlaceAndContinueAcrossSeams) {
    const std::vector<CoarseView> views = unevenly_exposed();
    const Backdrop b = estimate_backdrop(views, {}, {}, 0);
    const BackdropPaint paint = paint_backdrop(b, views, 0);
    ASSERT_EQ(paint.view.size(), b.positions.size());
    double before = 0, after = 0;
    std::size_t seams = 0, unpainted = 0, shown = 0;
    for (std::uint32_t u = 0; u < b.positions.size(); ++u) {
        const auto count =
            std::ranges::count_if(views, [&](const auto& v) { return shows(v, b.positions[u]); });
        shown += count >= 2;
        unpainted += count >= 2 && paint.view[u] == BackdropPaint::none;
        if (paint.view[u] == BackdropPaint::none) continue;
        const CoarseView& mine = views[paint.view[u]];
        ASSERT_TRUE(shows(mine, b.positions[u]));
        ASSERT_TRUE(paint.correction[u].isFinite().all());
        for (const std::uint32_t v : b.sphere.neighbors[u]) {
            if (v == DirectionSphere::none || paint.view[v] == BackdropPaint::none ||
                paint.view[v] == paint.view[u] || !shows(views[paint.view[v]], b.positions[u]))
                continue;
            const Eigen::Array3f here = root_of(sample(mine, in_camera(mine, b.positions[u]), 1).ln),
                                 other = root_of(sample(views[paint.view[v]],
                                                        in_camera(views[paint.view[v]], b.positions[u]), 1)
                                                     .ln);
            before += (here - other).abs().mean();
            after += (here + paint.correction[u] - other - paint.correction[v]).abs().mean();
            ++seams;
        }
    }
    EXPECT_EQ(unpainted, 0u) << "of " << shown;
    ASSERT_GT(seams, 100u);
    EXPECT_LT(after, 0.5 * before) << before / double(seams) << " on average at " << seams << " seams";
    EXPECT_LT(after / double(seams), 4.0 / 255);
}

TEST(PhotoLabels, ThereAreNoneWherePhotosShowNothing) {
    const std::vector<CoarseView> views = yard::photos();
    const Backdrop b = estimate_backdrop(views, {}, {}, 0);
    const BackdropPaint paint = paint_backdrop(b, views, 0);
    for (std::size_t d = 0; d < b.positions.size(); ++d) {
        const auto kind = [&](const CoarseView& v) {
            return sample(v, in_camera(v, b.positions[d]), 1).kind;
        };
        if (std::ranges::count(views, ViewSample::open, kind) > 0) continue;
        ASSERT_EQ(paint.view[d], BackdropPaint::none);
        if (std::ranges::count(views, ViewSample::nothing, kind) == std::ptrdiff_t(views.size())) {
            ASSERT_LT(paint.trust[d], 0.7f) << "the minimum if only one photo shows it";
        }
    }
}
