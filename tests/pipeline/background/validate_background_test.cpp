#include "pipeline/background/validate_background.h"

#include <gtest/gtest.h>

#include "tests/pipeline/background/yard.h"

using namespace vantage;

namespace {

BackgroundVerdict validate(std::vector<CoarseView> views) {
    const std::size_t n = views.size();
    const CoarseViews all{std::move(views),
                          {std::vector<std::array<double, 3>>(n), std::vector<Vignetting>(n)}};
    const std::vector<package::PhotoRecord> photos(n);
    const std::vector<std::span<const package::SampleRecord>> samples(n);
    const std::vector<std::uint32_t> lens(n, 0);
    return validate_background(all, {photos, samples, lens}, {}, 6, 0);
}

}  // namespace

TEST(BackgroundVerdict, AYardIsPredictedByItsPhotos) {
    const BackgroundVerdict j = validate(yard::photos());
    EXPECT_EQ(j.objection(KindOfScan::object), "");
    EXPECT_GT(j.gain.gain, 3);
}

TEST(BackgroundVerdict, ABackgroundThatMovesWithTheCameraIsATurntables) {
    const BackgroundVerdict j =
        validate(yard::photos([](const auto&, const auto&, const Eigen::Vector2d& pixel) {
            return Eigen::Array3f::Constant(float(yard::texture(pixel.x() / 12, pixel.y() / 12)));
        }));
    EXPECT_NE(j.objection(KindOfScan::object).find("moves with the camera"), std::string::npos)
        << j.objection(KindOfScan::object);
}

TEST(BackgroundVerdict, APlainBackgroundIsLeftAlone) {
    const BackgroundVerdict j =
        validate(yard::photos([](const auto&, const auto&, const Eigen::Vector2d& pixel) {
            return Eigen::Array3f::Constant(float(0.7 + 0.01 * std::sin(pixel.x())));
        }));
    EXPECT_EQ(j.objection(KindOfScan::object), "the background is plain");
}
