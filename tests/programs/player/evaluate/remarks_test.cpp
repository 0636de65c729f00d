// Tests the causes of errors that evaluate reports: cameras, passers-by, exposure, noise.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "base/values/srgb.h"
#include "pipeline/run/settings.h"
#include "player/measure/evaluation/held_out.h"
#include "tests/programs/player/evaluate/evaluated_scene.h"

using namespace vantage;

namespace {

Cause largest_at_colored(const CauseSquares& s) {
    Cause most = Cause::displaced;
    for (const CauseRow& row : cause_table())
        if (s.colored_share(row.cause) > s.colored_share(most)) most = row.cause;
    return most;
}

bool remarks_on(const PhotoEvaluation& r, const std::string& what) {
    return std::ranges::any_of(r.remarks, [&](const std::string& s) { return s.find(what) != s.npos; });
}

bool reports_offset(const PhotoEvaluation& r) {
    return std::ranges::any_of(r.remarks, [](const std::string& s) { return s.starts_with("offset by"); });
}

}  // namespace

TEST_F(EvaluateAtLength, GoodSceneGetsNoRemarks) {
    for (const PhotoEvaluation& r : evaluate()) {
        EXPECT_GT(r.score.psnr_gain, 22) << r.name;
        EXPECT_LT(std::hypot(r.shift[0], r.shift[1]), 0.5) << r.name;
        EXPECT_LT(std::abs(r.brightness.stops), 0.1) << r.name << ": equal exposures";
        EXPECT_FALSE(reports_offset(r)) << r.name;
    }
}

TEST_F(EvaluateAtLength, WrongCameraIsDetectedWithItsOffset) {
    constexpr double off = 2.5;  // pixels at full size
    Camera& camera = scene.photos[2].camera;
    Pose& pose = camera.cam_from_world;
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(off / camera.intrinsics.fx, Eigen::Vector3d::UnitY()).toRotationMatrix();
    pose.R = turn * pose.R;
    pose.t = turn * pose.t;
    const std::vector<PhotoEvaluation> results = evaluate();
    // Points are projected farther to the right in the rotated camera, so the photo's content is to the left
    // of them.
    EXPECT_NEAR(std::abs(results[2].shift[0]), off, 0.8);
    EXPECT_LT(std::abs(results[2].shift[1]), 0.5);
    EXPECT_TRUE(reports_offset(results[2]));
    for (const PhotoEvaluation& r : results)  // the others are also blended with it, so they are slightly off
        EXPECT_LT(std::hypot(r.shift[0], r.shift[1]), r.photo == 2 ? 2 * off : 0.7 * off) << r.name;
}

TEST_F(EvaluateAtLength, PasserByInTheHeldOutPhotoMakesItOdd) {
    repaint(scene.photos[2].file, paint_passer_by);
    const PhotoEvaluation r = evaluate_photo(2);
    EXPECT_EQ(largest_at_colored(r.causes), Cause::odd_photo);
    const auto region = std::ranges::find(r.worst, Cause::odd_photo, &WorstRegion::cause);
    ASSERT_NE(region, r.worst.end());
    EXPECT_LT(std::abs(region->place.x + region->place.width / 2 - 205), 60) << "at half size";
    EXPECT_LT(std::abs(region->place.y + region->place.height / 2 - 150), 80);
}

TEST_F(EvaluateAtLength, DarkThingInFrontIsNotCalledExposure) {
    repaint(scene.photos[2].file, [](std::array<std::uint8_t, 3>& color, int x, int) {
        if (x < 360) color = {20, 40, 15};
    });
    const PhotoEvaluation r = evaluate_photo(2);
    EXPECT_LT(std::abs(r.brightness.stops), 0.15);
    EXPECT_FALSE(remarks_on(r, "darker"));
    EXPECT_TRUE(remarks_on(r, "something in front of it"));
}

TEST_F(Evaluate, DarkerPhotoIsReportedWithItsStops) {
    repaint(scene.photos[2].file, [](std::array<std::uint8_t, 3>& color, int, int) {
        for (std::uint8_t& v : color)
            v = std::uint8_t(
                std::lround(255 * srgb_from_linear(linear_from_srgb(v / 255.0) * std::exp2(-0.5))));
    });
    const PhotoEvaluation r = evaluate_photo(2, false);
    EXPECT_NEAR(r.brightness.stops, -0.5, 0.1);
    EXPECT_TRUE(remarks_on(r, "stops darker than the others"));
    EXPECT_FALSE(remarks_on(r, "something in front of it"));
}

TEST_F(EvaluateAtLength, PasserByInAnotherPhotoIsADisagreement) {
    repaint(scene.photos[1].file, paint_passer_by);
    const std::vector<PhotoEvaluation> results = evaluate();
    EXPECT_EQ(largest_at_colored(results[1].causes), Cause::odd_photo);
    EXPECT_EQ(largest_at_colored(results[2].causes), Cause::disagreement);
}

TEST_F(EvaluateAtLength, WrongCameraDisplacesContent) {
    Pose& pose = scene.photos[2].camera.cam_from_world;
    const double angle = 7 / scene.photos[2].camera.intrinsics.fx;
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitX()).toRotationMatrix();
    pose.R = turn * pose.R;
    pose.t = turn * pose.t;
    const PhotoEvaluation r = evaluate_photo(2);
    EXPECT_EQ(largest_at_colored(r.causes), Cause::displaced);
    EXPECT_GT(r.causes.colored_share(Cause::displaced), 0.5);
}

TEST_F(EvaluateAtLength, NoisyPhotoDiffersInFineDetail) {
    std::mt19937 random(4);
    repaint(scene.photos[2].file, [&](std::array<std::uint8_t, 3>& color, int, int) {
        for (std::uint8_t& v : color) v = std::uint8_t(std::clamp(int(v) + int(random() % 161) - 80, 0, 255));
    });
    EXPECT_EQ(largest_at_colored(evaluate_photo(2).causes), Cause::detail);
}
