// Compares lens tables with the equations of the models in double precision.
#include "scene/package/contents/lens_table.h"

#include <gtest/gtest.h>

#include <random>

#include "base/values/tiling.h"
#include "scene/package/contents/pinhole_image.h"

namespace vantage {
namespace {

struct Case {
    const char* what;
    Intrinsics camera;
    Lens lens;
};

/// Lenses of every model, with typical and stronger distortion.
std::vector<Case> cases() {
    const Intrinsics telephone{4640, 2610, 3500, 3500, 2330, 1290}, wide{4000, 3000, 2000, 2000, 2010, 1480},
        fisheye{4000, 4000, 1300, 1300, 2000, 2000}, small{240, 180, 200, 200, 120, 90};
    return {
        {"a telephone by Metashape", telephone, {LensModel::opencv, {0.15, -1.2, 0, 0, 2.2}}},
        {"rational, wide",
         wide,
         {LensModel::opencv, {-0.28, 0.09, 0.001, -0.001, -0.013, 0.02, 0.01, 0.001}}},
        {"barrel, a small photo", small, {LensModel::opencv, {-0.1}}},
        {"fisheye by OpenCV", fisheye, {LensModel::fisheye, {-0.02, 0.01, -0.004, 0.0006}}},
        {"field of view", wide, {LensModel::fov, {0.93}}},
        {"thin prism",
         fisheye,
         {LensModel::thin_prism, {-0.02, 0.01, 0.001, 0.001, -0.004, 0, 0.001, 0.002}}},
        {"up to r^8 with skew", wide, {LensModel::brown, {-0.1, 0.06, 0.001, 0.001, -0.02, 0.003, 0.0005}}},
        {"fisheye with thin prism",
         fisheye,
         {LensModel::aria, {-0.02, 0.01, -0.004, 0.001, 0, 0, 0.001, 0.001}}},
        {"division", wide, {LensModel::division, {-0.15}}},
        {"MatchMover", wide, {LensModel::matchmover, {0.08}}},
        {"extended unified", fisheye, {LensModel::unified, {0.6, 1.1}}},
    };
}

/// The pixel position computed with the model's equation.
Eigen::Vector2d exact(const Case& c, const Eigen::Vector2d& pixel) {
    const Intrinsics& k = c.camera;
    const Eigen::Vector2d d = distort(c.lens, {(pixel.x() - k.cx) / k.fx, (pixel.y() - k.cy) / k.fy});
    return {k.fx * d.x() + k.cx, k.fy * d.y() + k.cy};
}

double radius(const Case& c, const Eigen::Vector2d& pixel) {
    return std::hypot((pixel.x() - c.camera.cx) / c.camera.fx, (pixel.y() - c.camera.cy) / c.camera.fy);
}

TEST(LensTables, AreWithinAFiftiethOfAPixelOfEveryModel) {
    std::mt19937 random(7);
    for (const Case& c : cases()) {
        const LensTable table = lens_table(c.camera, c.lens);
        std::uniform_real_distribution<double> x(0, c.camera.width), y(0, c.camera.height);
        double worst = 0, moved = 0;
        for (int i = 0; i < 20000; ++i) {
            const Eigen::Vector2d pixel(x(random), y(random));
            if (radius(c, pixel) > table.range) continue;
            worst = std::max(worst, (photo_pixel(table, pixel) - exact(c, pixel)).norm());
            moved = std::max(moved, (exact(c, pixel) - pixel).norm());
        }
        std::printf("%-28s moves pixels by up to %6.1f px, with an error of at most %.5f px\n", c.what, moved,
                    worst);
        EXPECT_LE(worst, 0.02) << c.what;
        EXPECT_GE(moved, 1) << c.what;
    }
}

TEST(LensTables, EndAtTheRangeOfTheLens) {
    Case c{"folds", {400, 400, 200, 200, 200, 200}, {LensModel::opencv, {-0.6}}};
    const double fold = std::sqrt(1 / 1.8);
    const LensTable table = lens_table(c.camera, c.lens);
    for (double r = 0.01; r < 1; r += 0.01) {
        const Eigen::Vector2d pixel(200 + 200 * r * 0.6, 200 + 200 * r * 0.8),
            taken = photo_pixel(table, pixel);
        EXPECT_EQ(taken.allFinite(), r < fold) << r;
        if (r < fold - 0.05) {
            EXPECT_LE((taken - exact(c, pixel)).norm(), 0.02) << r;
        }
    }
}

TEST(LensTables, BoundsHoldWhatTheyAreOf) {
    std::mt19937 random(8);
    for (const Case& c : cases()) {
        const LensTable table = lens_table(c.camera, c.lens);
        std::uniform_real_distribution<double> x(0, c.camera.width), y(0, c.camera.height);
        for (int i = 0; i < 100; ++i) {
            Eigen::AlignedBox2d box(Eigen::Vector2d(x(random), y(random)));
            box.extend(Eigen::Vector2d(x(random), y(random)));
            const Eigen::AlignedBox2d to = photo_bounds(table, box);
            for (int j = 0; j < 20; ++j) {
                const Eigen::Vector2d at = photo_pixel(table, box.sample());
                if (at.allFinite()) {
                    EXPECT_LE(to.exteriorDistance(at), 1e-3) << c.what;
                }
            }
        }
    }
}

TEST(LensTables, TellWhichTexelsThePhotoShows) {
    for (const Case& c : cases()) {
        constexpr int level = 3;
        const LensTable table = lens_table(c.camera, c.lens);
        const Level size = level_size(c.camera.width, c.camera.height, level);
        std::vector<std::uint8_t> inside = inside_photo(table, level);
        const bool all = inside.empty();
        if (all) inside.assign(std::size_t(size.width) * std::size_t(size.height), 1);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                const Eigen::Vector2d pixel(8 * (x + 0.5), 8 * (y + 0.5)), at = exact(c, pixel);
                const double edge =
                    std::min({at.x(), at.y(), c.camera.width - at.x(), c.camera.height - at.y(),
                              1e9 * (table.range - radius(c, pixel))});
                const bool shown = inside[std::size_t(y) * std::size_t(size.width) + std::size_t(x)];
                if (edge > 8.1) {
                    ASSERT_TRUE(shown) << c.what << ' ' << x << ' ' << y;
                }
                if (edge < 7.9) {
                    ASSERT_FALSE(shown) << c.what << ' ' << x << ' ' << y;
                }
            }
    }
}

TEST(LensTables, OfAbsurdLensesAreFinite) {
    std::mt19937 random(6);
    std::normal_distribution<double> normal;
    for (int trial = 0; trial < 300; ++trial) {
        Lens lens{LensModel(1 + trial % int(last_lens_model)), {}};
        for (double& p : lens.p) p = std::pow(10, 3 * normal(random)) * (random() % 2 ? 1 : -1);
        const LensTable table = lens_table({60, 40, 30, 30, 30, 20}, lens);
        for (const Eigen::Vector2f& d : table.displaced) ASSERT_TRUE(d.allFinite()) << trial;
        EXPECT_TRUE(std::isfinite(table.range));
    }
}

TEST(PinholeImages, AreSampledOnceWhereTheLensImages) {
    // A photo of a smooth function. The function's value at the exact position is the reference.
    const Case c{"barrel", {400, 300, 300, 300, 205, 148}, {LensModel::opencv, {-0.15, 0.02}}};
    const auto value = [](const Eigen::Vector2d& p) {
        return 128 + 60 * std::sin(p.x() / 9) + 50 * std::cos(p.y() / 7);
    };
    RgbaImage photo = blank_image(c.camera.width, c.camera.height);
    for (int y = 0; y < photo.height; ++y)
        for (int x = 0; x < photo.width; ++x)
            for (int ch = 0; ch < 4; ++ch)
                photo.rgba[4 * std::size_t(y * photo.width + x) + std::size_t(ch)] =
                    ch == 3 ? 255 : std::uint8_t(std::lround(value({x + 0.5, y + 0.5})));
    const RgbaImage out = pinhole_image(photo, lens_table(c.camera, c.lens), 0);
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            const Eigen::Vector2d at = exact(c, {x + 0.5, y + 0.5});
            const std::uint8_t* color = &out.rgba[4 * std::size_t(y * out.width + x)];
            ASSERT_EQ(color[3], 255) << "with barrel distortion, the whole frame is covered";
            if (at.x() > 2 && at.y() > 2 && at.x() < 398 && at.y() < 298) {
                ASSERT_NEAR(color[0], value(at), 1.6) << x << ',' << y;
            }
        }
}

}  // namespace
}  // namespace vantage
