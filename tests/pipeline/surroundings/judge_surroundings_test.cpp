#include "pipeline/surroundings/judge_surroundings.h"

#include <gtest/gtest.h>

#include "tests/pipeline/surroundings/yard.h"

using namespace vantage;

namespace {

SurroundingsJudgment judge(std::vector<CoarseView> views) {
    const std::size_t n = views.size();
    const CoarseViews all{std::move(views), {std::vector<std::array<double, 3>>(n), std::vector<Falloff>(n)}};
    const std::vector<package::PhotoRecord> photos(n);
    const std::vector<std::span<const package::SampleRecord>> samples(n);
    const std::vector<std::uint32_t> lens(n, 0);
    return judge_surroundings(all, samples, photos, lens, {}, 6, 0);
}

}  // namespace

TEST(SurroundingsJudgment, AYardIsPredictedByItsPhotos) {
    const SurroundingsJudgment j = judge(yard::photos());
    EXPECT_EQ(j.objection(KindOfScan::object), "");
    EXPECT_GT(j.gain.gain, 3);
}

TEST(SurroundingsJudgment, ABackgroundThatMovesWithTheCameraIsATurntables) {
    const SurroundingsJudgment j =
        judge(yard::photos([](const auto&, const auto&, const Eigen::Vector2d& pixel) {
            return Eigen::Array3f::Constant(float(yard::texture(pixel.x() / 12, pixel.y() / 12)));
        }));
    EXPECT_NE(j.objection(KindOfScan::object).find("moves with the camera"), std::string::npos)
        << j.objection(KindOfScan::object);
}

TEST(SurroundingsJudgment, APlainBackgroundIsLeftAlone) {
    const SurroundingsJudgment j =
        judge(yard::photos([](const auto&, const auto&, const Eigen::Vector2d& pixel) {
            return Eigen::Array3f::Constant(float(0.7 + 0.01 * std::sin(pixel.x())));
        }));
    EXPECT_EQ(j.objection(KindOfScan::object), "the background is plain");
}
