#include "pipeline/reports/inspect/camera_facts.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "pipeline/reports/inspect/scale_facts.h"

namespace vantage {
namespace {

constexpr double degree = std::numbers::pi / 180;

Camera camera_with(LensModel model, std::array<double, 12> p = {}) {
    return {.intrinsics = {.width = 200, .height = 100, .fx = 100, .fy = 100, .cx = 100, .cy = 50},
            .lens = {model, p},
            .cam_from_world = {}};
}

TEST(FieldOfView, OfAPinholeIsThatOfItsTriangle) {
    Camera camera = camera_with(LensModel::none);
    EXPECT_NEAR(field_of_view(camera, 0), 90, 1e-6);
    EXPECT_NEAR(field_of_view(camera, 1), 2 * std::atan(0.5) / degree, 1e-6);
    camera.intrinsics.cx = 250;  // outside the frame
    EXPECT_NEAR(field_of_view(camera, 0), (std::atan(2.5) - std::atan(0.5)) / degree, 1e-6);
}

TEST(FieldOfView, OfAnEquidistantFisheyeIsProportionalToTheFrame) {
    EXPECT_NEAR(field_of_view(camera_with(LensModel::fisheye), 0), 2 / degree, 1e-6);
    EXPECT_NEAR(field_of_view(camera_with(LensModel::fisheye), 1), 1 / degree, 1e-6);
}

TEST(FieldOfView, EndsWhereTheLensDoes) {
    // x (1 - x^2 / 3) has its maximum, 2/3, at x = 1, so directions beyond 45 degrees have no image.
    EXPECT_NEAR(field_of_view(camera_with(LensModel::opencv, {-1 / 3.0}), 0), 90, 1e-3);
    // The radius r' in the photo corresponds to r = r' / (1 + k r'^2), which is at most 1 / (2 sqrt(k)), here
    // 1.
    EXPECT_NEAR(field_of_view(camera_with(LensModel::division, {0.25}), 0), 2 * std::atan(0.8) / degree,
                1e-3);
}

TEST(FieldOfView, IsUnknownWithoutTheFrame) {
    Camera camera = camera_with(LensModel::none);
    camera.intrinsics.width = 0;
    EXPECT_TRUE(std::isnan(field_of_view(camera, 0)));
}

TEST(CameraFacts, GroupCamerasBySizeAndLens) {
    std::vector<CameraSet::Entry> cameras;
    for (const double k1 : {0.1, 0.2, 0.1}) cameras.push_back({"a", camera_with(LensModel::opencv, {k1})});
    cameras.push_back({"b", camera_with(LensModel::none)});
    cameras.back().camera.cam_from_world.t = {0, 0, -7};
    const CameraFacts facts = camera_facts(cameras);
    EXPECT_EQ(facts.cameras, 4u);
    EXPECT_EQ(facts.centers.max().z(), 7);
    ASSERT_EQ(facts.lenses.size(), 2u);
    const LensFacts& lens = facts.lenses.front();
    EXPECT_EQ(lens.cameras, 3u);
    EXPECT_EQ(lens.calibrations, 2u);
    ASSERT_EQ(lens.coefficients.size(), 1u);
    EXPECT_STREQ(lens.coefficients[0].name, "k1");
    EXPECT_EQ(lens.coefficients[0].value.low, 0.1);
    EXPECT_EQ(lens.coefficients[0].value.high, 0.2);
    EXPECT_TRUE(facts.lenses.back().coefficients.empty());
}

TEST(CameraFacts, NumbersThatCannotBeAreNotCounted) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    std::vector<CameraSet::Entry> cameras(3, {"a", camera_with(LensModel::none)});
    cameras[0].camera.intrinsics.fx = nan;
    cameras[1].camera.intrinsics.fy = 0;
    cameras[2].camera.cam_from_world.t.x() = nan;
    const CameraFacts facts = camera_facts(cameras);
    ASSERT_EQ(facts.lenses.size(), 1u);
    EXPECT_EQ(facts.lenses[0].cameras, 3u);
    EXPECT_EQ(facts.lenses[0].calibrations, 1u);
    EXPECT_EQ(facts.lenses[0].focal_x.high, 100);
    EXPECT_TRUE(camera_facts({}).lenses.empty());
}

/// A coefficient has a name if and only if the lens depends on it.
TEST(LensCoefficients, ThoseThatMatterHaveNames) {
    for (int m = 0; m <= int(last_lens_model); ++m) {
        const auto model = LensModel(m);
        const std::size_t names = coefficient_names(model).size();
        for (std::size_t i = 0; i < std::tuple_size_v<decltype(Lens::p)>; ++i) {
            Lens lens{model, {}};
            if (model == LensModel::unified) lens.p = {0.5, 0.5};  // neither has an effect without the other
            const Eigen::Vector2d ray(0.5, 0.3), before = distort(lens, ray);
            lens.p[i] += 0.1;
            EXPECT_EQ(distort(lens, ray) != before, i < names) << name(model) << ", coefficient " << i;
        }
    }
}

TEST(Scale, UnitsAreGuessedFromTheDistance) {
    using Names = std::vector<std::string>;
    EXPECT_EQ(plausible_units(8), Names{"m"});
    EXPECT_EQ(plausible_units(30), (Names{"m", "cm"}));
    EXPECT_EQ(plausible_units(400), (Names{"m", "cm", "mm"}));
    EXPECT_EQ(plausible_units(20000), (Names{"cm", "mm"}));
    EXPECT_EQ(plausible_units(0.01), Names{});
    EXPECT_EQ(plausible_units(std::numeric_limits<double>::quiet_NaN()), Names{});
}

}  // namespace
}  // namespace vantage
