#include "scene/agreement/color_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "pipeline/refine/color_agreement.h"
#include "pipeline/stages/surface_samples.h"
#include "pipeline/visibility/photo_geometry.h"

using namespace vantage;
using package::SampleRecord;

namespace {

/// Synthetic photos of one surface, represented by samples of all discs.
struct SyntheticPhotos {
    std::vector<std::vector<SampleRecord>> photos;
    std::vector<std::array<double, 3>> gain;  ///< true gain per photo and channel

    std::vector<std::span<const SampleRecord>> spans() const { return {photos.begin(), photos.end()}; }
    std::vector<std::uint32_t> one_lens() const { return std::vector<std::uint32_t>(photos.size(), 0); }
};

struct PhotoOptions {
    std::size_t photos = 12, discs = 3000;
    double share = 0.4;     ///< fraction of the discs that each photo shows
    double stops = 1;       ///< largest exposure error, in either direction
    double vignetting = 0;  ///< fraction of the light lost in the corner
    double noise = 0.02, outliers = 0;
};

/// Vignetting whose form differs from the one that is fitted.
double light_at(double r, double lost) { return 1 / std::pow(1 + (1 / std::sqrt(1 - lost) - 1) * r * r, 2); }

SyntheticPhotos make(const PhotoOptions& w, unsigned seed = 1) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    std::normal_distribution<double> normal;
    SyntheticPhotos made;
    std::vector<std::array<double, 3>> albedo(w.discs);
    for (auto& a : albedo)
        for (double& c : a) c = std::exp(-0.7 - 1.5 * unit(random));
    for (std::size_t i = 0; i < w.photos; ++i) {
        auto& gain = made.gain.emplace_back();
        for (double& g : gain) g = std::exp2(w.stops * (2 * unit(random) - 1));
        auto& photo = made.photos.emplace_back(w.discs, SampleRecord{});
        for (std::size_t d = 0; d < w.discs; ++d) {
            if (unit(random) > w.share) continue;
            const double r = std::sqrt(unit(random));
            const double wrong = unit(random) < w.outliers ? std::exp(2 * normal(random)) : 1;
            photo[d].radius = std::uint16_t(std::lround(65535 * r));
            for (std::size_t c = 0; c < 3; ++c)
                photo[d].linear[c] = std::uint16_t(
                    std::clamp(65535 * 0.4 * albedo[d][c] * gain[c] * light_at(r, w.vignetting) * wrong *
                                   std::exp(w.noise * normal(random)),
                               1.0, 65535.0));
        }
    }
    return made;
}

/// The largest error of ln gain, relative to the mean over photos.
double worst_gain(const SyntheticPhotos& made, const ColorFit& fit) {
    double worst = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        double mean = 0;
        for (std::size_t i = 0; i < made.gain.size(); ++i)
            mean += (std::log(made.gain[i][c]) + fit.ln_gain[i][c]) / double(made.gain.size());
        for (std::size_t i = 0; i < made.gain.size(); ++i)
            worst = std::max(worst, std::abs(std::log(made.gain[i][c]) + fit.ln_gain[i][c] - mean));
    }
    return worst;
}

void expect_untouched(const ColorFit& fit) {
    for (const auto& g : fit.ln_gain)
        for (const double v : g) EXPECT_EQ(v, 0);
    for (const Vignetting& f : fit.vignetting)
        for (const double v : f) EXPECT_EQ(v, 0);
    EXPECT_EQ(fit.before, 0);
    EXPECT_EQ(fit.after, 0);
}

}  // namespace

TEST(ColorFit, RecoversGainsAndVignettingDespiteOutliers) {
    const SyntheticPhotos made = make({.vignetting = 0.3, .outliers = 0.1});
    const ColorFit fit = fit_colors(made.spans(), made.one_lens(), true);
    EXPECT_LT(worst_gain(made, fit), 0.005);
    for (double r = 0; r <= 1; r += 0.05)
        EXPECT_NEAR(std::exp(-log_vignetting(fit.vignetting[0], r)), light_at(r, 0.3), 0.01) << r;
    EXPECT_GT(fit.before, 0.3);
    EXPECT_LT(fit.after, 0.05);
}

TEST(ColorFit, AgreeingPhotosStayUnchanged) {
    const SyntheticPhotos made = make({.stops = 0});
    const ColorFit fit = fit_colors(made.spans(), made.one_lens(), true);
    for (const auto& g : fit.ln_gain)
        for (const double v : g) EXPECT_NEAR(v, 0, 0.005);
    for (const double f : fit.vignetting[0]) EXPECT_EQ(f, 0);
}

TEST(ColorFit, EachLensHasItsOwnVignetting) {
    SyntheticPhotos made = make({.photos = 6, .share = 0.8, .stops = 0.5, .vignetting = 0.4});
    const SyntheticPhotos others = make({.photos = 6, .share = 0.8, .stops = 0.5});
    made.photos.insert(made.photos.end(), others.photos.begin(), others.photos.end());
    const std::vector<std::uint32_t> lens{0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1};
    const ColorFit fit = fit_colors(made.spans(), lens, true);
    EXPECT_NEAR(std::exp(-log_vignetting(fit.vignetting[0], 1)), 0.6, 0.02);
    EXPECT_EQ(log_vignetting(fit.vignetting[1], 1), 0);
}

TEST(ColorFit, TwoPhotosDoNotDetermineTheVignetting) {
    // A bright center in two photos may be part of the object; in three photos, it is attributed to the lens.
    SyntheticPhotos made = make({.photos = 6, .stops = 0});
    const SyntheticPhotos shining = make({.photos = 3, .stops = 0, .vignetting = 0.4});
    std::vector<std::uint32_t> lens(6, 0);
    for (const std::size_t photos : {1u, 2u, 3u}) {
        made.photos.push_back(shining.photos[photos - 1]);
        lens.push_back(1);
        const ColorFit fit = fit_colors(made.spans(), lens, true);
        EXPECT_EQ(log_vignetting(fit.vignetting[0], 1), 0) << photos;
        EXPECT_EQ(log_vignetting(fit.vignetting[1], 1) > 0, photos == 3) << photos;
    }
}

TEST(ColorFit, NegligibleVignettingIsDropped) {
    // A corner loses a tenth of the light, with little and with much noise.
    for (const double noise : {0.02, 1.0}) {
        const SyntheticPhotos made = make({.share = 0.8, .stops = 0, .vignetting = 0.1, .noise = noise});
        const ColorFit fit = fit_colors(made.spans(), made.one_lens(), true);
        EXPECT_EQ(log_vignetting(fit.vignetting[0], 1) > 0, noise < 0.1) << noise;
    }
}

TEST(ColorFit, DisconnectedGroupsAreFittedSeparately) {
    SyntheticPhotos made = make({.photos = 5, .discs = 1000});
    const SyntheticPhotos others = make({.photos = 4, .discs = 1000}, 2);
    for (auto& photo : made.photos) photo.resize(2000, SampleRecord{});
    for (const auto& photo : others.photos) {
        made.photos.emplace_back(1000, SampleRecord{});
        made.photos.back().insert(made.photos.back().end(), photo.begin(), photo.end());
    }
    const ColorFit fit = fit_colors(made.spans(), made.one_lens(), false);
    for (std::size_t i = 0; i < 9; ++i) EXPECT_EQ(fit.component[i], i < 5 ? 0u : 5u);
    for (std::size_t c = 0; c < 3; ++c) {
        double first = 0, second = 0;
        for (std::size_t i = 0; i < 9; ++i) (i < 5 ? first : second) += fit.ln_gain[i][c];
        EXPECT_NEAR(first, 0, 1e-9);
        EXPECT_NEAR(second, 0, 1e-9);
    }
}

TEST(ColorFit, NothingChangesWithoutSharedSurface) {
    expect_untouched(fit_colors({}, {}, true));
    const SyntheticPhotos alone = make({.photos = 1});
    expect_untouched(fit_colors(alone.spans(), alone.one_lens(), true));
    SyntheticPhotos clipped = make({.photos = 3});
    for (auto& photo : clipped.photos) std::ranges::fill(photo, SampleRecord{});
    expect_untouched(fit_colors(clipped.spans(), clipped.one_lens(), true));
    SyntheticPhotos few = make({.photos = 3, .discs = 20, .share = 1});
    expect_untouched(fit_colors(few.spans(), few.one_lens(), true));
}

TEST(ColorFit, DuplicatePhotoStaysUnchanged) {
    SyntheticPhotos made = make({.photos = 1});
    made.photos.push_back(made.photos.front());
    const ColorFit fit = fit_colors(made.spans(), made.one_lens(), true);
    for (const auto& g : fit.ln_gain)
        for (const double v : g) EXPECT_NEAR(v, 0, 1e-9);
}

TEST(ColorFit, OutliersOnlyGiveFiniteGainsWithinBounds) {
    const SyntheticPhotos made = make({.photos = 6, .noise = 3});
    const ColorFit fit = fit_colors(made.spans(), made.one_lens(), true);
    for (const auto& g : fit.ln_gain)
        for (const double v : g) EXPECT_LE(std::abs(v), std::log(4) + 1e-12);
    for (const double f : fit.vignetting[0]) EXPECT_TRUE(std::isfinite(f));
}

TEST(ColorAgreement, IsEnabledOnlyIfPhotosDisagree) {
    std::vector<package::PhotoRecord> photos(12);
    for (package::PhotoRecord& p : photos) p.width = 300, p.height = 200, p.fx = 300, p.levels = 1;
    const auto refine = [&](const SyntheticPhotos& made, const std::map<Effect, EffectChoice>& choices) {
        const auto spans = made.spans();
        return refine_colors(fit_colors(spans, lenses_of(photos), true), lenses_of(photos), spans, choices);
    };
    const auto agreeing = refine(make({.stops = 0, .noise = 0.005}), {});
    EXPECT_FALSE(agreeing.exposure.on) << agreeing.exposure.evidence;
    EXPECT_FALSE(agreeing.vignetting.on);
    // Gains do not explain this disagreement.
    const auto noisy = refine(make({.stops = 0, .noise = 0.1}), {});
    EXPECT_FALSE(noisy.exposure.on) << noisy.exposure.evidence;
    const SyntheticPhotos exposed = make({.vignetting = 0.3});
    const auto called = refine(exposed, {});
    EXPECT_TRUE(called.exposure.on) << called.exposure.evidence;
    EXPECT_TRUE(called.vignetting.on) << called.vignetting.evidence;
    const auto forbidden =
        refine(exposed, {{Effect::exposure, EffectChoice::off}, {Effect::vignetting, EffectChoice::off}});
    apply_colors(forbidden, photos);
    for (const package::PhotoRecord& p : photos)
        for (int i = 0; i < 3; ++i) {
            EXPECT_EQ(p.gain[i], 1);
            EXPECT_EQ(p.vignetting[i], 0);
        }
}

TEST(SurfaceDiscs, AreSpreadHalfByAreaAndHalfByTriangles) {
    // One large triangle has nearly all the area, and 999 tiny triangles have the rest. The large one gets
    // half of the discs, and the tiny ones together get the other half.
    std::vector<Eigen::Vector3f> positions{{0, 0, 0}, {10, 0, 0}, {0, 10, 0}};
    std::vector<std::uint32_t> indices{0, 1, 2};
    for (int i = 0; i < 999; ++i) {
        const auto at = std::uint32_t(positions.size());
        const float x = 20 + 0.01f * float(i);
        for (const auto& p :
             {Eigen::Vector3f(x, 0, 0), Eigen::Vector3f(x + 0.01f, 0, 0), Eigen::Vector3f(x, 0.01f, 0)})
            positions.push_back(p);
        for (std::uint32_t v = 0; v < 3; ++v) indices.push_back(at + v);
    }
    const auto discs = surface_disc_set(positions, indices, 100);
    ASSERT_EQ(discs.size(), package::surface_discs);
    std::size_t large = 0;
    for (const SurfaceDisc& d : discs) {
        large += d.center.x() <= 10;
        EXPECT_NEAR(d.normal.norm(), 1, 1e-5);
    }
    EXPECT_NEAR(double(large), 0.5 * double(package::surface_discs), 0.01 * double(package::surface_discs));
    EXPECT_TRUE(surface_disc_set(positions, {}, 100).empty());
    // A triangle that extends far beyond the model does not take all the discs.
    const auto far = std::uint32_t(positions.size());
    positions.push_back({0, 0, 1e6f});
    indices.insert(indices.end(), {0, 1, far});
    const auto with = surface_disc_set(
        positions, indices, 100, Eigen::AlignedBox3d(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(50, 10, 1)));
    EXPECT_LE(double(std::ranges::count_if(with, [](const auto& d) { return std::abs(d.center.z()) > 1; })),
              0.01 * double(package::surface_discs));
}

TEST(SurfaceDiscs, AreSampledOnlyWhereClearlyVisible) {
    // A wall at z = 10. A nearer surface occludes its left half, and colors encode the position.
    const Intrinsics k{800, 600, 800, 800, 400, 300};
    PhotoGeometry geometry{400, 300, std::vector<float>(400 * 300, 10), {}, {}};
    for (std::size_t i = 0; i < geometry.z.size(); ++i)
        if (i % 400 < 200) geometry.z[i] = 5;
    RgbaImage photo{200, 150, std::vector<std::uint8_t>(200 * 150 * 4, 255), true};
    for (std::size_t i = 0; i < 200 * 150; ++i) {
        photo.rgba[4 * i] = 128;
        photo.rgba[4 * i + 1] = std::uint8_t(60 + i % 200 / 2);
        photo.rgba[4 * i + 2] = i / 200 < 20 ? 250 : 128;  // clipped at the top
    }
    for (std::size_t i = 140 * 200; i < 150 * 200; ++i) photo.rgba[4 * i + 3] = 0;
    const auto at = [&](double x, double y, const Eigen::Vector3f& normal = {0, 0, -1}) {
        const Eigen::Vector3f center(float((x - 400) / 80), float((y - 300) / 80), 10);
        const SurfaceDisc disc{center, normal, 0.25f};
        return sample_discs(std::span(&disc, 1), photo, geometry, k, Pose{})[0];
    };
    const SampleRecord seen = at(600, 300);
    EXPECT_NEAR(seen.linear[0], 65535 * 0.2159, 65535 * 0.002);  // sRGB 128
    EXPECT_NEAR(seen.linear[1], 65535 * std::pow((135 / 255.0 + 0.055) / 1.055, 2.4), 65535 * 0.01);
    EXPECT_NEAR(seen.radius, 65535 * 200 / 500, 2);
    for (const SampleRecord& none : {at(200, 300), at(600, 40), at(600, 590), at(900, 300),
                                     at(600, 300, {0.999f, 0, -0.04f}), at(600, 300, {0, 0, 0})})
        for (const std::uint16_t c : none.linear) EXPECT_EQ(c, 0);
}
