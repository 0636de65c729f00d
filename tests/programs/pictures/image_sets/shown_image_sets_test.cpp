// Tests pictures of image sets: one alone, two mixed, and one replacing another.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include "base/gl/context.h"
#include "base/values/srgb.h"
#include "pipeline/prepare/prepare.h"
#include "player/render/picture.h"
#include "scene/package/contents/image_sets.h"
#include "tests/programs/pictures/image_sets/image_set_scene.h"

using namespace vantage;
namespace fs = std::filesystem;

namespace {

std::vector<std::uint32_t> all(const PackageReader& package) {
    std::vector<std::uint32_t> photos(package.photos().size());
    std::iota(photos.begin(), photos.end(), 0u);
    return photos;
}

/// A view from the front, between the cameras of both image sets.
View front() { return view_towards({1, -9, 0}, {0, 0, 0}, {0, 0, 1}, 45, 200, 150); }

Picture taken(Renderer& renderer, const RenderSettings& settings) {
    return take_picture(renderer, front(), settings, all(renderer.package()), 1);
}

RenderSettings of(const ImageSetSettings& image_sets) {
    RenderSettings s;
    s.image_sets = image_sets;
    return s;
}

double mean_difference(const Picture& a, const Picture& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i) sum += std::abs(int(a.rgba[i]) - int(b.rgba[i]));
    return sum / double(a.rgba.size());
}

/// The mean of two sRGB values, computed with square roots of linear light.
double mixed(int a, int b, double share) {
    const double root =
        (1 - share) * std::sqrt(linear_from_srgb(a / 255.0)) + share * std::sqrt(linear_from_srgb(b / 255.0));
    return 255 * srgb_from_linear(root * root);
}

/// The largest difference between a mixed picture and the mean of two pictures, in 8-bit values.
double largest_error(const Picture& a, const Picture& b, const Picture& mix, double share) {
    double worst = 0;
    for (std::size_t i = 0; i < mix.rgba.size(); i += 4) {
        worst = std::max(
            worst, std::abs((1 - share) * a.rgba[i + 3] + share * b.rgba[i + 3] - double(mix.rgba[i + 3])));
        if (a.rgba[i + 3] < 255 || b.rgba[i + 3] < 255) continue;
        for (std::size_t c = i; c < i + 3; ++c)
            worst = std::max(worst, std::abs(mixed(a.rgba[c], b.rgba[c], share) - double(mix.rgba[c])));
    }
    return worst;
}

}  // namespace

TEST_F(ImageSets, CrossFadeIsTheMeanOfBothPictures) {
    make(small_scene());
    const PackageReader package = prepared();
    const gl::HeadlessContext context;
    Renderer renderer(package, MemoryBudget{});
    for (const bool fills : {false, true}) {
        const auto picture = [&](const ImageSetSettings& image_sets) {
            RenderSettings s = of(image_sets);
            s.fill_holes = fills;
            return taken(renderer, s);
        };
        const Picture a = picture({.shown = visible}), b = picture({.shown = infrared});
        EXPECT_GT(mean_difference(a, b), 10);
        const auto mix = [&](double share) {
            return picture({.shown = visible, .other = infrared, .share = share});
        };
        EXPECT_EQ(mix(0).rgba, a.rgba);
        EXPECT_EQ(mix(1).rgba, b.rgba);
        for (const double share : {0.25, 0.5})
            EXPECT_LE(largest_error(a, b, mix(share), share), 1.1) << share << " " << fills;
    }
}

TEST_F(ImageSets, DividedPicturesShowEachImageSetOnItsSide) {
    make(small_scene());
    const PackageReader package = prepared();
    const gl::HeadlessContext context;
    Renderer renderer(package, MemoryBudget{});
    const Picture a = taken(renderer, of({.shown = visible})), b = taken(renderer, of({.shown = infrared}));
    const auto expect_from = [&](const Picture& whole, int x, const Picture& got, int at) {
        for (int y = 0; y < got.height; ++y)
            for (int c = 0; c < 4; ++c)
                ASSERT_EQ(got.rgba[std::size_t(4 * (y * got.width + at) + c)],
                          whole.rgba[std::size_t(4 * (y * got.width + x) + c)])
                    << at << "," << y;
    };
    const Picture swipe =
        taken(renderer, of({.shown = visible, .other = infrared, .how = ImageSetView::swipe, .swipe = 0.3}));
    const Picture beside =
        taken(renderer, of({.shown = visible, .other = infrared, .how = ImageSetView::side_by_side}));
    for (int x = 0; x < a.width; ++x) {
        if (std::abs(x - 60) > 2) expect_from(x < 60 ? a : b, x, swipe, x);
        if (std::abs(x - 100) > 2) expect_from(x < 100 ? a : b, x % 100 + 50, beside, x);
    }
}

TEST_F(ImageSets, PhotosOfOneImageSetAreNeverBlendedIntoTheOther) {
    SynthSpec spec = small_scene();
    spec.exposure.stops = 0.5;
    spec.garden = {.radius = 30, .hill = 8};
    make(spec);
    fs::copy(dir / "scene", dir / "noise", fs::copy_options::recursive);
    add_noise("noise");
    for (const bool background : {false, true}) {
        PrepareSettings settings;
        if (background) settings.effects[Effect::background] = EffectChoice::on;
        const PackageReader one = prepared("scene", settings), other = prepared("noise", settings);
        ASSERT_EQ(effect_on(one.scene(), Effect::background), effect_on(other.scene(), Effect::background));
        EXPECT_TRUE(!background || effect_on(one.scene(), Effect::background));
        EXPECT_TRUE(read_image_sets(one)[visible].effects & effect_bit(Effect::exposure));
        const gl::HeadlessContext context;
        Renderer a(one, MemoryBudget{}), b(other, MemoryBudget{});
        EXPECT_GT(mean_difference(taken(a, of({.shown = infrared})), taken(b, of({.shown = infrared}))), 10);
        for (int blend = 0; blend < int(Blend::count); ++blend)
            for (const bool second_round : {false, true})
                for (const int photos : {0, 2}) {
                    RenderSettings s;
                    s.blend = Blend(blend);
                    s.transients = second_round;
                    s.photos = photos;
                    s.fill_holes = background;
                    EXPECT_EQ(taken(a, s).rgba, taken(b, s).rgba)
                        << blend << " " << second_round << " " << photos << " " << background;
                }
    }
}

TEST_F(ImageSets, LookAsIfTheyWereAlone) {
    SynthSpec spec = small_scene();
    spec.exposure.stops = 0.5;
    make(spec);
    spec.infrared.count = 0;
    make(spec, "alone");
    const PackageReader both = prepared(), alone = prepared("alone");
    const gl::HeadlessContext context;
    Renderer a(both, MemoryBudget{}), b(alone, MemoryBudget{});
    RenderSettings s;
    s.blend = Blend::average;  // where distances to cameras matter most
    for (const int photos : {0, 2}) {
        s.photos = photos;
        const Picture in_both = taken(a, s), by_itself = taken(b, s);
        int worst = 0;
        for (std::size_t i = 0; i < in_both.rgba.size(); ++i)
            worst = std::max(worst, std::abs(int(in_both.rgba[i]) - int(by_itself.rgba[i])));
        EXPECT_LE(worst, 1) << photos;
    }
}

TEST_F(ImageSets, AImageSetThatTakesAnothersPlaceLeavesNoHole) {
    make(small_scene());
    const PackageReader package = prepared();
    const gl::HeadlessContext context;
    Renderer renderer(package, MemoryBudget{});
    RenderSettings s;
    s.loading = Loading::streamed;
    s.photos = 2;
    s.fill_holes = true;
    s.upload_bytes = std::size_t(1) << 20;
    double now = 0;
    const auto frame = [&] {
        now += 1.0 / 30;
        const FrameReport report = renderer.draw(front(), s, all(package), {}, now);
        EXPECT_LE(report.uploaded, s.upload_bytes);
        return report.settled;
    };
    const auto settle = [&](const auto& look) {
        for (int i = 0; i < 600; ++i) {
            const bool settled = frame();
            look(shown_picture(renderer, front(), s));
            if (settled) return true;
        }
        return false;
    };
    ASSERT_TRUE(settle([](const Picture&) {}));
    const Picture before = shown_picture(renderer, front(), s);
    std::vector<Picture> shown;
    s.image_sets.shown = infrared;
    ASSERT_TRUE(settle([&](const Picture& p) { shown.push_back(p); }));
    EXPECT_GT(mean_difference(before, shown.back()), 10);
    EXPECT_LT(mean_difference(before, shown.front()), 0.1)
        << "the new image set's photos are not loaded yet, so the picture should not change";
    const auto settled_at =
        std::ranges::find_if(shown, [&](const Picture& p) { return mean_difference(before, p) > 0.1; });
    EXPECT_GE(shown.end() - settled_at, 5) << "it fades in";
    for (std::size_t f = 0; f < shown.size(); ++f) {
        std::size_t of_neither = 0;  // near edges, until the finest tiles are loaded
        for (std::size_t i = 0; i < before.rgba.size(); ++i) {
            const int low = std::min(before.rgba[i], shown.back().rgba[i]),
                      high = std::max(before.rgba[i], shown.back().rgba[i]), is = shown[f].rgba[i];
            of_neither += is < low - 24 || is > high + 24;
        }
        EXPECT_LT(double(of_neither) / double(before.rgba.size()), 0.02) << "frame " << f;
    }
    s.image_sets = {.shown = infrared, .other = visible, .share = 0.5};
    ASSERT_TRUE(settle([](const Picture&) {}));
    EXPECT_LE(largest_error(before, shown.back(), shown_picture(renderer, front(), s), 0.5), 2);
}

TEST_F(ImageSets, BothEyesSeeThem) {
    make(small_scene());
    const PackageReader package = prepared();
    const gl::HeadlessContext context;
    Renderer renderer(package, MemoryBudget{});
    std::array<View, 2> eyes{front(), front()};
    eyes[1].cam_from_origin.t.x() -= 0.3;
    RenderSettings s;
    s.loading = Loading::streamed;
    s.fill_holes = true;
    double now = 0;
    const auto settle = [&] {
        for (int i = 0; i < 600; ++i) {
            now += 1.0 / 30;
            FrameReport report = renderer.prepare({eyes, s, all(package), {}, now});
            for (const std::size_t eye : {0, 1}) renderer.paint(eye, report);
            if (report.settled) return true;
        }
        return false;
    };
    ASSERT_TRUE(settle());
    s.image_sets = {.shown = infrared, .other = visible, .share = 0.5};
    ASSERT_TRUE(settle());
    Renderer alone(package, MemoryBudget{});
    for (const std::size_t eye : {0, 1}) {
        const Picture of_pair = picture_of(frame_size(eyes[eye]), [&](GLuint target) {
            renderer.show(eyes[eye], s, {target, false, eye});
        });
        RenderSettings single = s;
        single.loading = Loading::complete;
        EXPECT_LT(mean_difference(of_pair, take_picture(alone, eyes[eye], single, all(package), 1)), 1);
    }
}
