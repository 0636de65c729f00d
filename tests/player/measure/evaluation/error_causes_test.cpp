#include "player/measure/evaluation/error_causes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "player/measure/evaluation/worst_regions.h"
#include "player/measure/whole_frame.h"
#include "tests/player/measure/waves.h"

using namespace vantage;

namespace {

/// A photo that others predict without error until a test disturbs it.
struct Constructed {
    Picture photo, shown;
    std::vector<Picture> alone;
    std::vector<bool> taken, colored, surface;

    CauseMap causes() const {
        const Plane errors = squared_errors(photo, shown, taken, colored, {1, 1, 1});
        return find_causes({photo, shown, alone, errors, taken, colored, surface});
    }
    CauseSquares squares() const { return causes().totals(); }
};

void each(const Place& p, const Picture& picture, const auto& visit) {
    for (int y = p.y; y < p.y + p.height; ++y)
        for (int x = p.x; x < p.x + p.width; ++x)
            visit(std::size_t(y) * std::size_t(picture.width) + std::size_t(x), x, y);
}

Constructed constructed(int width = 192, int height = 128) {
    const Picture p = waves(width, height);
    const std::vector<bool> all(p.rgba.size() / 4, true);
    return {p, p, {p, p, p}, all, all, all};
}

constexpr Place passer_by{64, 48, 64, 48};

void paint(Picture& p, const Place& place, int share = 100) {
    each(place, p, [&](std::size_t i, int, int) {
        const int red[3] = {230, 20, 40};
        for (std::size_t c = 0; c < 3; ++c)
            p.rgba[4 * i + c] = std::uint8_t((p.rgba[4 * i + c] * (100 - share) + red[c] * share) / 100);
    });
}

Cause largest(const CauseSquares& s) { return Cause(std::ranges::max_element(s) - s.begin()); }

}  // namespace

TEST(ErrorCauses, NoErrorNoCause) {
    const CauseSquares s = constructed().squares();
    EXPECT_EQ(s.all(), 0);
    for (const CauseRow& row : cause_table()) {
        EXPECT_EQ(s.share(row.cause), 0);
        EXPECT_EQ(s.colored_share(row.cause), 0);
    }
    EXPECT_TRUE(worst_regions(constructed().causes(), 4).empty());
}

TEST(ErrorCauses, PasserByInThePhotoIsOdd) {
    Constructed c = constructed();
    paint(c.photo, passer_by);
    EXPECT_GT(c.squares().share(Cause::odd_photo), 0.9);
}

TEST(ErrorCauses, PasserByInOneOfTheOthersIsADisagreement) {
    Constructed c = constructed();
    paint(c.alone[1], passer_by);
    paint(c.shown, passer_by, 50);
    EXPECT_GT(c.squares().share(Cause::disagreement), 0.9);
}

TEST(ErrorCauses, PasserByInAPhotoThatIsNotAmongThoseComparedIsADisagreement) {
    Constructed c = constructed();
    paint(c.shown, passer_by, 50);
    EXPECT_GT(c.squares().share(Cause::disagreement), 0.9);
}

TEST(ErrorCauses, OthersThatAreAllWrongInDifferentWaysDisagree) {
    Constructed c = constructed();
    const auto brighten = [](Picture& p, int by) {
        each(passer_by, p, [&](std::size_t i, int, int) {
            for (std::size_t k = 0; k < 3; ++k)
                p.rgba[4 * i + k] = std::uint8_t(std::clamp(p.rgba[4 * i + k] + by, 0, 255));
        });
    };
    c.alone.pop_back();
    brighten(c.alone[0], 50);
    brighten(c.alone[1], -50);
    brighten(c.shown, 30);
    EXPECT_GT(c.squares().share(Cause::disagreement), 0.9);
}

TEST(ErrorCauses, PasserByThatOnlyOnePhotoContradictsIsNotJudged) {
    Constructed c = constructed();
    paint(c.photo, passer_by);
    for (std::size_t k = 1; k < 3; ++k)
        for (std::size_t i = 3; i < c.alone[k].rgba.size(); i += 4) c.alone[k].rgba[i] = 0;
    EXPECT_GT(c.squares().share(Cause::unjudged), 0.9);
}

TEST(ErrorCauses, ShiftedContentIsDisplaced) {
    for (const auto& [dx, dy] : {std::pair(3, -2), {-1, 0}, {6, 6}}) {
        Constructed c = constructed();
        c.photo = waves(192, 128, dx, dy);
        EXPECT_GT(c.squares().share(Cause::displaced), 0.9) << dx << ' ' << dy;
    }
}

TEST(ErrorCauses, OthersDisplacedInOppositeDirectionsAreDisplacedNotDisagreeing) {
    Constructed c = constructed();
    c.alone = {waves(192, 128, 3, 0), waves(192, 128, -3, 0)};
    for (std::size_t i = 0; i < c.shown.rgba.size(); ++i)
        c.shown.rgba[i] = std::uint8_t((c.alone[0].rgba[i] + c.alone[1].rgba[i]) / 2);
    EXPECT_GT(c.squares().share(Cause::displaced), 0.9);
}

TEST(ErrorCauses, BlurAndNoiseAreFineDetail) {
    Constructed noisy = constructed();
    std::mt19937 random(2);
    for (std::size_t i = 0; i < noisy.photo.rgba.size(); ++i)
        if (i % 4 < 3)
            noisy.photo.rgba[i] =
                std::uint8_t(std::clamp(noisy.photo.rgba[i] + int(random() % 31) - 15, 0, 255));
    EXPECT_GT(noisy.squares().share(Cause::detail), 0.9);
    Constructed stripes = constructed();  // of two pixels, which the others blur to gray
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 192; ++x)
            for (std::size_t c = 0; c < 3; ++c) {
                const std::size_t i = std::size_t(4 * (y * 192 + x)) + c;
                stripes.shown.rgba[i] = 128;
                stripes.photo.rgba[i] = x / 2 % 2 ? 160 : 96;
            }
    EXPECT_GT(stripes.squares().share(Cause::detail), 0.9);
}

TEST(ErrorCauses, BrightnessOnAGradientIsNoDisplacement) {
    Constructed c = constructed();
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 192; ++x)
            for (std::size_t k = 0; k < 3; ++k) {
                const std::size_t i = std::size_t(4 * (y * 192 + x)) + k;
                c.shown.rgba[i] = std::uint8_t(30 + x);
                c.photo.rgba[i] = std::uint8_t(34 + x);
                for (Picture& p : c.alone) p.rgba[i] = c.shown.rgba[i];
            }
    EXPECT_EQ(largest(c.squares()), Cause::odd_photo);
    EXPECT_EQ(c.squares().of(Cause::displaced), 0);
}

TEST(ErrorCauses, HolesAreToldApartByTheMesh) {
    Constructed c = constructed();
    each({0, 0, 192, 40}, c.photo, [&](std::size_t i, int, int) {
        c.colored[i] = c.surface[i] = false;
        c.shown.rgba[4 * i] = 0;
    });
    each({0, 100, 192, 10}, c.photo, [&](std::size_t i, int, int) {
        c.colored[i] = false;
        c.shown.rgba[4 * i] = 0;
    });
    const CauseSquares s = c.squares();
    EXPECT_GT(s.share(Cause::no_surface), 0.6);
    EXPECT_NEAR(s.share(Cause::no_surface) + s.share(Cause::unseen), 1, 1e-9);
    EXPECT_EQ(s.colored(), 0);
    EXPECT_EQ(s.colored_share(Cause::odd_photo), 0) << "not NaN";
}

TEST(ErrorCauses, SharesAddUpToTheFramesError) {
    Constructed c = constructed(101, 67);  // not multiples of a cell
    c.photo = waves(101, 67, 0.7, 0.4);
    paint(c.photo, {40, 30, 20, 20});
    for (std::size_t i = 0; i < 300; ++i) c.colored[i] = false;
    for (std::size_t i = 3000; i < 3200; ++i) c.taken[i] = false;
    const FrameScore frame = score_frame(c.photo, c.shown, c.taken, c.colored, {1, 1, 1},
                                         squared_errors(c.photo, c.shown, c.taken, c.colored, {1, 1, 1}));
    EXPECT_NEAR(psnr_of(c.squares().all(), frame.pixels), frame.psnr, 1e-6);
    double sum = 0;
    for (const CauseRow& row : cause_table()) sum += c.squares().share(row.cause);
    EXPECT_NEAR(sum, 1, 1e-9);
}

TEST(ErrorCauses, WorstRegionIsWhereTheCauseIs) {
    Constructed c = constructed();
    paint(c.photo, {136, 72, 40, 40});
    const CauseMap map = c.causes();
    const std::vector<WorstRegion> worst = worst_regions(map, 4);
    ASSERT_FALSE(worst.empty());
    EXPECT_EQ(worst[0].cause, Cause::odd_photo);
    const Place& p = worst[0].place;
    EXPECT_TRUE(p.x <= 140 && p.x + p.width >= 170 && p.y <= 80 && p.y + p.height >= 104)
        << p.x << ' ' << p.y;
    EXPECT_LE(worst[0].squares, map.totals().all());
    const Picture picture = cause_picture(map);
    const auto cell = [&](int x, int y) { return &picture.rgba[std::size_t(4 * (y * picture.width + x))]; };
    EXPECT_EQ(cell(150 / 16, 90 / 16)[0], cause_row(Cause::odd_photo).color[0]);
    EXPECT_EQ(cell(1, 1)[0], 0) << "no error: black";
}

TEST(ErrorCauses, SmallAndEmptyFrames) {
    for (const auto& [width, height] : {std::pair(1, 1), {5, 3}, {17, 16}}) {
        Constructed c = constructed(width, height);
        c.alone.clear();
        paint(c.photo, {0, 0, width, height});
        EXPECT_GT(c.squares().all(), 0);
        EXPECT_TRUE(std::isfinite(c.squares().all()));
        EXPECT_FALSE(worst_regions(c.causes(), 4).empty());
        c.taken.assign(c.taken.size(), false);
        EXPECT_EQ(c.squares().all(), 0);
        EXPECT_EQ(score_frame(c.photo, c.shown, c.taken, c.colored, {1, 1, 1}, Plane(width, height)).psnr, 0);
    }
}
