// Runs the solvers on underdetermined, inconsistent and invalid problems: the cost must never rise, and the
// results must be finite and within bounds.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <random>

#include "pipeline/refine/poses/common_motion.h"
#include "pipeline/refine/poses/pose_fit.h"
#include "scene/agreement/color_fit.h"

using namespace vantage;
using package::SampleRecord;

namespace {

const Intrinsics k{1200, 900, 1100, 1100, 600, 450};
constexpr double distance = 10;

/// Cameras side by side in front of a wavy wall, with exact tracks of points on the wall.
struct Rig {
    std::vector<FittedCamera> cameras;
    std::vector<Track> tracks;
    std::vector<PoseChange> change;
};

Pose at(double x) {
    Pose p;
    p.R = Eigen::AngleAxisd(0.05 * x, Eigen::Vector3d::UnitY()).toRotationMatrix();
    p.t = -p.R * Eigen::Vector3d(x, 0, -distance);
    return p;
}

/// `groups` is the number of groups of cameras; cameras in different groups share no tracks.
Rig rig(int cameras, int tracks, int groups = 1) {
    Rig r;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int i = 0; i < cameras; ++i) r.cameras.push_back({k, at(i - 0.5 * cameras), distance, false});
    for (int s = 0; s < tracks; ++s) {
        Track track;
        const int group = s % groups;
        track.point = {4 * unit(random), 3 * unit(random), unit(random)};
        track.normal = Eigen::Vector3d(0.3 * unit(random), 0.3 * unit(random), -1).normalized();
        bool first = true;
        for (int i = group; i < cameras; i += groups) {
            const auto seen = project(k, r.cameras[std::size_t(i)].given, track.point);
            if (first) {
                track.photo = std::uint32_t(i);
                track.pixel = seen->pixel;
                first = false;
            } else {
                track.matches.push_back({std::uint32_t(i), seen->pixel, Eigen::Vector2d::Zero()});
            }
        }
        r.tracks.push_back(track);
    }
    r.change.assign(std::size_t(cameras), PoseChange{});
    return r;
}

/// Displaces each camera randomly by about `pixels`.
void disturb(Rig& r, double pixels) {
    std::mt19937 random(4);
    std::normal_distribution<double> normal(0, pixels);
    for (FittedCamera& c : r.cameras) {
        PoseChange by{};
        for (double& v : by) v = normal(random) / std::sqrt(6);
        c.given = apply_change(c, by);
    }
}

double largest(const Rig& r) {
    double most = 0;
    for (const PoseChange& c : r.change)
        for (const double v : c) {
            if (!std::isfinite(v)) return std::numeric_limits<double>::infinity();
            most = std::max(most, std::abs(v));
        }
    return most;
}

PoseFit solve(Rig& r, double anchor = 5, double sigma = 3) {
    const PoseFit fit = fit_poses(r.cameras, r.tracks, anchor, sigma, r.change);
    EXPECT_TRUE(std::isfinite(fit.before) && std::isfinite(fit.after));
    EXPECT_TRUE(!fit.usable || fit.after <= fit.before);
    return fit;
}

/// A track seen by the cameras at x = -1 and 0.
Track seen_twice(const Eigen::Vector3d& x) {
    Track s;
    s.photo = 0;
    s.point = x;
    s.normal = -Eigen::Vector3d::UnitZ();
    s.pixel = project(k, at(-1), x)->pixel;
    s.matches.push_back({1, project(k, at(0), x)->pixel, Eigen::Vector2d::Zero()});
    return s;
}

}  // namespace

TEST(PoseSolver, NoTracksLeavePosesUnchanged) {
    Rig empty = rig(3, 0);
    EXPECT_FALSE(solve(empty).usable);
    EXPECT_EQ(largest(empty), 0);
    Rig lonely = rig(1, 20);  // tracks in a single photo
    EXPECT_FALSE(solve(lonely).usable);
    EXPECT_EQ(largest(lonely), 0);
}

TEST(PoseSolver, FreeFrameWithoutAnAnchorStaysFinite) {
    Rig r = rig(4, 200);
    disturb(r, 3);
    // The anchor is so weak that all cameras can move together: the cost is flat in six directions.
    const PoseFit fit = solve(r, 1e-12, 1);
    EXPECT_TRUE(fit.usable);
    EXPECT_LT(largest(r), 200);
}

TEST(PoseSolver, TooFewTracksAreHeldByTheAnchor) {
    Rig r = rig(2, 2);  // two tracks: four equations, twelve unknowns
    disturb(r, 2);
    EXPECT_TRUE(solve(r).usable);
    EXPECT_LT(largest(r), 20);
}

TEST(PoseSolver, DisconnectedGroupsAreSolvedSeparately) {
    Rig together = rig(6, 300, 2);
    disturb(together, 2);
    solve(together);
    EXPECT_LT(largest(together), 20);
    // Solving one group alone gives the same result.
    Rig alone = rig(6, 300, 2);
    disturb(alone, 2);
    std::erase_if(alone.tracks, [](const Track& s) { return s.photo != 0; });
    solve(alone);
    for (const std::size_t i : {0u, 2u, 4u})
        for (std::size_t c = 0; c < 6; ++c) EXPECT_NEAR(together.change[i][c], alone.change[i][c], 1e-3);
}

TEST(PoseSolver, FarOutlierHasNoInfluence) {
    Rig clean = rig(4, 200), with = rig(4, 200);
    disturb(clean, 2);
    disturb(with, 2);
    with.tracks[7].matches[0].pixel = {1e9, -1e9};
    solve(clean);
    solve(with);
    for (std::size_t i = 0; i < clean.change.size(); ++i)
        for (std::size_t c = 0; c < 6; ++c) EXPECT_NEAR(with.change[i][c], clean.change[i][c], 0.2);
}

// A non-finite residual makes Ceres abort for all photos.
TEST(PoseSolver, NonFiniteTracksAndPointsBehindCamerasAreIgnored) {
    Rig clean = rig(4, 200), with = rig(4, 200);
    disturb(clean, 2);
    disturb(with, 2);
    const double infinite = std::numeric_limits<double>::infinity();
    with.tracks[7].matches[0].pixel = {infinite, 0};
    with.tracks[8].pixel = {std::nan(""), 0};
    with.tracks[9].point = {0, 0, -3 * distance};
    with.tracks[10].point.x() = std::nan("");
    with.tracks[11].normal.setConstant(std::nan(""));
    with.tracks[12].matches[0].pixel = {1e200, 0};  // its square overflows
    EXPECT_TRUE(solve(clean).usable);
    EXPECT_TRUE(solve(with).usable);
    for (std::size_t i = 0; i < clean.change.size(); ++i)
        for (std::size_t c = 0; c < 6; ++c) EXPECT_NEAR(with.change[i][c], clean.change[i][c], 0.3);
    Rig nothing = rig(4, 50);
    for (Track& s : nothing.tracks) s.pixel.setConstant(infinite);
    EXPECT_FALSE(solve(nothing).usable);
    EXPECT_EQ(largest(nothing), 0);
}

TEST(PoseSolver, NanCostLeavesPosesUnchanged) {
    Rig r = rig(4, 200);
    disturb(r, 2);
    const PoseFit fit = solve(r, 0.05, 0);  // sigma of zero: 0/0
    EXPECT_FALSE(fit.usable);
    EXPECT_TRUE(std::isfinite(fit.before) && std::isfinite(fit.after));
    EXPECT_EQ(largest(r), 0);
}

TEST(PoseSolver, OutliersOnlyStayWithinReachOfTheAnchor) {
    Rig r = rig(5, 150);
    std::mt19937 random(9);
    for (Track& s : r.tracks)
        for (Match& m : s.matches) m.pixel = {double(random() % 1200), double(random() % 900)};
    solve(r);
    EXPECT_LT(largest(r), 1000);
    EXPECT_TRUE(std::isfinite(largest(r)));
}

TEST(CommonMotion, IsFiniteForNoPointsOnePointOrALine) {
    const std::vector<Intrinsics> ks(3, k);
    const std::vector<Pose> given{at(-1), at(0), at(1)};
    std::vector<Pose> now = given;
    for (Pose& p : now) p.t += Eigen::Vector3d(0.01, 0, 0);
    std::vector<Track> none, point, line;
    for (int i = 0; i < 20; ++i) {
        point.push_back(seen_twice({1 + 1e-13 * i, 1, 0}));
        line.push_back(seen_twice(Eigen::Vector3d(0.07, 0.03, 0.013) * i));
    }
    for (const auto* tracks : {&none, &point, &line}) {
        const Similarity s = common_motion(ks, given, now, *tracks);
        const Pose moved = compose(now[0], inverse(s));
        EXPECT_TRUE(moved.R.allFinite() && moved.t.allFinite()) << tracks->size();
        EXPECT_NEAR(moved.R.determinant(), 1, 1e-6);
        EXPECT_LT(Eigen::AngleAxisd(s.R).angle(), 0.1) << tracks->size();
        EXPECT_NEAR(s.scale, 1, 0.1) << tracks->size();
    }
}

TEST(CommonMotion, PointsOnALineDoNotCauseARotationAboutIt) {
    const std::vector<Intrinsics> ks(3, k);
    const std::vector<Pose> given{at(-1), at(0), at(1)};
    std::srand(3);
    for (int n = 0; n < 300; ++n) {
        const Eigen::Vector3d along = Eigen::Vector3d::Random() * 0.05, first = Eigen::Vector3d::Random();
        std::vector<Track> line;
        for (int i = 0; i < 20; ++i) line.push_back(seen_twice(first + along * i));
        std::vector<Pose> now = given;
        for (Pose& p : now) p.t += Eigen::Vector3d::Random() * 0.01;
        const Similarity s = common_motion(ks, given, now, line);
        EXPECT_LT(Eigen::AngleAxisd(s.R).angle(), 0.1) << n;
        EXPECT_NEAR(s.scale, 1, 0.1) << n;
    }
}

namespace {

using SamplesByPhoto = std::vector<std::vector<SampleRecord>>;

ColorFit fit(const SamplesByPhoto& photos) {
    const std::vector<std::span<const SampleRecord>> spans(photos.begin(), photos.end());
    const std::vector<std::uint32_t> lens(photos.size(), 0);
    ColorFit f = fit_colors(spans, lens, true);
    for (const auto& g : f.ln_gain)
        for (const double v : g) {
            EXPECT_TRUE(std::isfinite(v));
            EXPECT_LE(std::abs(v), std::log(4) + 1e-9);
        }
    for (const Vignetting& l : f.vignetting)
        for (const double v : l) EXPECT_TRUE(std::isfinite(v));
    EXPECT_TRUE(std::isfinite(f.before) && std::isfinite(f.after));
    EXPECT_LE(f.after, f.before + 1e-3);  // within a thousandth of the light
    return f;
}

SampleRecord sample(double light, double radius) {
    const auto u = std::uint16_t(std::lround(65535 * light));
    return {{u, u, u}, std::uint16_t(std::lround(65535 * radius))};
}

}  // namespace

TEST(ColorSolver, DiscsAtOneRadiusGiveNoVignetting) {
    SamplesByPhoto photos(4);
    for (std::size_t i = 0; i < photos.size(); ++i)
        for (int d = 0; d < 200; ++d) photos[i].push_back(sample(0.1 * std::exp2(0.3 * double(i)), 0.5));
    const ColorFit f = fit(photos);
    for (const double v : f.vignetting[0]) EXPECT_EQ(v, 0);
    EXPECT_LT(f.after, 1e-3);
}

TEST(ColorSolver, BridgeBetweenTwoGroupsJoinsThem) {
    // Photos 0 and 1 share many discs, as do photos 2 and 3; photos 1 and 2 share just enough to
    // connect these pairs.
    SamplesByPhoto photos(4, std::vector<SampleRecord>(400, SampleRecord{}));
    for (int d = 0; d < 180; ++d)
        for (const std::size_t i : {0u, 1u}) photos[i][std::size_t(d)] = sample(i ? 0.2 : 0.1, 0.3);
    for (int d = 180; d < 360; ++d)
        for (const std::size_t i : {2u, 3u}) photos[i][std::size_t(d)] = sample(i == 2 ? 0.3 : 0.6, 0.3);
    for (int d = 360; d < 395; ++d)
        for (const std::size_t i : {1u, 2u}) photos[i][std::size_t(d)] = sample(i == 1 ? 0.2 : 0.1, 0.3);
    const ColorFit f = fit(photos);
    EXPECT_NEAR(f.ln_gain[0][0] - f.ln_gain[1][0], std::log(2), 0.01);
    EXPECT_NEAR(f.ln_gain[2][0] - f.ln_gain[3][0], std::log(2), 0.01);
    EXPECT_NEAR(f.ln_gain[2][0] - f.ln_gain[1][0], std::log(2), 0.01);
}

TEST(ColorSolver, ExtremelyBrightDiscIsAnOutlier) {
    SamplesByPhoto photos(3, std::vector<SampleRecord>(300, sample(0.2, 0.4)));
    photos[1][17] = SampleRecord{{1, 1, 1}, 100};
    photos[2][90] = SampleRecord{{65535, 65535, 65535}, 65535};
    const ColorFit f = fit(photos);
    for (const auto& g : f.ln_gain) EXPECT_LT(std::abs(g[0]), 0.01);
}

TEST(ColorSolver, UnrelatedPhotosStayWithinBounds) {
    std::mt19937 random(2);
    SamplesByPhoto photos(6);
    for (auto& p : photos)
        for (int d = 0; d < 300; ++d)
            p.push_back({{std::uint16_t(1 + random() % 65535), std::uint16_t(1 + random() % 65535),
                          std::uint16_t(1 + random() % 65535)},
                         std::uint16_t(random() % 65536)});
    const std::vector<std::span<const SampleRecord>> spans(photos.begin(), photos.end());
    const ColorFit f = fit_colors(spans, std::vector<std::uint32_t>(6, 0), true);
    for (const auto& g : f.ln_gain)
        for (const double v : g) EXPECT_LE(std::abs(v), std::log(4) + 1e-9);
}

RC_GTEST_PROP(ColorSolver, AnyPhotosGiveFiniteValuesWithinBounds, ()) {
    const auto count = *rc::gen::inRange<std::size_t>(0, 6), discs = *rc::gen::inRange<std::size_t>(0, 120);
    const auto light = rc::gen::element<std::uint16_t>(0, 1, 9, 300, 20'000, 65'534, 65'535);
    const auto photos = *rc::gen::container<SamplesByPhoto>(
        count, rc::gen::container<std::vector<SampleRecord>>(
                   discs, rc::gen::apply(
                              [](std::uint16_t r, std::uint16_t g, std::uint16_t b, std::uint16_t radius) {
                                  return SampleRecord{{r, g, b}, radius};
                              },
                              light, light, light, rc::gen::arbitrary<std::uint16_t>())));
    const auto lens = *rc::gen::container<std::vector<std::uint32_t>>(count, rc::gen::inRange(0u, 3u));
    const std::vector<std::span<const SampleRecord>> spans(photos.begin(), photos.end());
    const ColorFit f = fit_colors(spans, lens, true);
    for (const auto& g : f.ln_gain)
        for (const double v : g) RC_ASSERT(std::abs(v) <= std::log(4) + 1e-9);
    for (const Vignetting& l : f.vignetting)
        for (const double v : l) RC_ASSERT(std::isfinite(v));
    RC_ASSERT(std::isfinite(f.before));
    RC_ASSERT(std::isfinite(f.after));
}
