// Tests how photos are used in pictures: exposures, sizes, lenses, masks, passers-by and the background.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/values/srgb.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/photos/image_files.h"
#include "pipeline/photos/photos.h"
#include "pipeline/photos/reduced.h"
#include "pipeline/prepare/prepare.h"
#include "pipeline/run/settings.h"
#include "pipeline/synth/synthesize.h"
#include "player/render/picture.h"
#include "scene/package/contents/background.h"
#include "scene/package/package_reader.h"
#include "tests/datasets.h"
#include "tests/made_scenes.h"
#include "tests/programs/pipeline/end_to_end/prepared_scene.h"

using namespace vantage;
namespace fs = std::filesystem;

namespace {

template <class Inside>
void paint(const PhotoInput& photo, const std::array<std::uint8_t, 3>& color, const Inside& inside) {
    const Intrinsics& k = photo.camera.intrinsics;
    const auto rgba = read_photo(photo.file, {k.width, k.height}).rgba;
    std::vector<std::uint8_t> rgb;
    for (int y = 0; y < k.height; ++y)
        for (int x = 0; x < k.width; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                rgb.push_back(inside(x, y)
                                  ? color[c]
                                  : rgba[4 * (std::size_t(y) * std::size_t(k.width) + std::size_t(x)) + c]);
    image_files().write(photo.file, k.width, k.height, 3, Sample::u8, std::as_bytes(std::span(rgb)));
}

}  // namespace

TEST_F(EndToEnd, BlendDoesNotDependOnPhotosPerPass) {
    Prepared p = prepared(make(tiny()));
    for (const Blend blend : {Blend::average, Blend::lumigraph, Blend::best}) {
        const Picture one = p.own_view(2, blend, 1);
        for (const int per_pass : {3, 16}) {
            const Picture many = p.own_view(2, blend, per_pass);
            const int rounding = blend == Blend::best ? 0 : 1;
            for (std::size_t i = 0; i < one.rgba.size(); ++i)
                ASSERT_NEAR(int(one.rgba[i]), int(many.rgba[i]), rounding) << int(blend) << " " << per_pass;
        }
    }
}

TEST_F(EndToEnd, BlackPixelsAreOpaque) {
    const fs::path scene = make(tiny());
    const Picture before = prepared(scene).own_view(2, Blend::average);
    for (const auto& photo : fs::directory_iterator(scene / "images"))
        image_files().write(photo.path(), 331, 250, 3, Sample::u8, std::vector<std::byte>(331 * 250 * 3));
    const Picture black = prepared(scene).own_view(2, Blend::average);
    for (std::size_t i = 0; i < black.rgba.size(); i += 4) {
        ASSERT_EQ(int(black.rgba[i]), 0);
        ASSERT_EQ(int(black.rgba[i + 3]), int(before.rgba[i + 3]));
    }
}

TEST_F(EndToEnd, ExcludedPhotoDoesNotContribute) {
    const fs::path scene = make(tiny());
    PrepareSettings settings;
    settings.effects[Effect::background] = EffectChoice::off;  // their shape depends on all photos
    PrepareSettings without = settings;
    without.hold_out = {"0002"};
    const Picture held = Prepared(scene, dir / "held.vantage", without).own_view(2, Blend::average);
    Prepared all(scene, dir / "scene.vantage", settings);
    std::erase(all.photos, 2u);
    const Picture excluded = all.own_view(2, Blend::average);
    EXPECT_EQ(excluded.rgba, held.rgba);
    const auto photo = read_photo(all.scene.photos[2].file, {331, 250}).rgba;
    for (const Picture& picture : {excluded, all.own_view(2, Blend::lumigraph)}) {
        EXPECT_GE(psnr(picture, photo), 22);
        EXPECT_LE(psnr(picture, photo), 40);
    }
}

TEST_F(EndToEnd, PhotosCoarserThanThePictureCountLess) {
    SynthSpec spec = tiny();
    spec.photos.width = 662, spec.photos.height = 500;
    spec.photos.arc = 40;
    SceneInput input = read_scene(discover(make(spec)));
    // A neighbor of photo 2, reduced to a quarter of its size.
    PhotoInput& coarse = input.photos[1];
    RgbaImage image = read_photo(coarse.file, {662, 500});
    image = reduced(image, {166, 125});
    std::vector<std::uint8_t> rgb;
    for (std::size_t i = 0; i < image.rgba.size(); ++i)
        if (i % 4 < 3) rgb.push_back(image.rgba[i]);
    image_files().write(coarse.file, 166, 125, 3, Sample::u8, std::as_bytes(std::span(rgb)));
    coarse.camera.intrinsics = coarse.camera.intrinsics.scaled(166, 125);
    coarse.read.clear();  // changed intentionally
    Prepared p(std::move(input), dir / "scene.vantage");
    const auto photo = read_photo(p.scene.photos[2].file, {662, 500}).rgba;
    std::erase(p.photos, 2u);
    const auto gain_of_weights = [&](double scale, const std::vector<std::uint8_t>& truth) {
        RenderSettings settings;
        const View view = view_of_photo(p.package->photos()[2], scale);
        const double with = psnr(p.picture(view, settings), truth);
        settings.weights.depth_weight = false;
        return with - psnr(p.picture(view, settings), truth);
    };
    EXPECT_GT(gain_of_weights(1, photo), 0.05);
    const RgbaImage whole{662, 500, photo}, small = reduced(whole, {82, 62});
    EXPECT_NEAR(gain_of_weights(0.124, small.rgba), 0, 0.02)
        << "there should be no gain where all photos have sufficient resolution";
}

TEST_F(EndToEnd, PhotosAreReducedToTheRequestedSize) {
    const fs::path scene = make(tiny());
    PrepareSettings settings;
    settings.photo_size = 166;
    Prepared p(scene, dir / "small.vantage", settings);
    const Picture small = p.own_view(1, Blend::best);
    ASSERT_EQ(small.width, 166);
    const RgbaImage photo = read_photo(p.scene.photos[1].file, {331, 250});
    EXPECT_GE(psnr(small, reduced(photo, thumbnail_size(photo.width, photo.height, 166)).rgba), 40);
}

TEST_F(EndToEnd, DifferentExposuresAreReconciled) {
    SynthSpec spec = tiny();
    spec.photos.width = 662, spec.photos.height = 500;
    spec.photos.arc = 50;
    spec.exposure = {0.7, 0.2, 0.3};
    Prepared p = prepared(make(spec));
    ASSERT_TRUE(effect_on(p.package->scene(), Effect::exposure));
    ASSERT_TRUE(effect_on(p.package->scene(), Effect::vignetting));
    for (const std::uint32_t i : {1u, 2u, 3u}) {
        const auto photo = read_photo(p.scene.photos[i].file, {662, 500}).rgba;
        EXPECT_GE(psnr(p.own_view(i, Blend::best), photo), 40)
            << "the picture should have the photo's own vignetting and exposure";
        std::vector<std::uint32_t> others = p.photos;
        std::erase(others, i);
        const View view = view_of_photo(p.package->photos()[i], 1);
        RenderSettings settings;
        const double agreeing = psnr(take_picture(*p.renderer, view, settings, others, 1), photo);
        settings.refined_colors = false;
        const double original = psnr(take_picture(*p.renderer, view, settings, others, 1), photo);
        std::printf(
            "photo %u from the others: %.1f dB with matched exposures, %.1f dB with the original ones\n", i,
            agreeing, original);
        EXPECT_GT(agreeing, original + 5);
    }
    // Pictures with the mean exposure of the photos and with the exposure of another photo.
    RenderSettings settings;
    View view = view_of_photo(p.package->photos()[1], 1);
    view.exposure = {};
    const Picture mean = p.picture(view, settings);
    settings.exposure = 2;
    const Picture as_second = p.picture(view, settings);
    const std::size_t middle = 4 * (std::size_t(250) * 662 + 331);
    const auto& linear = linear_of_srgb_byte();
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(linear[mean.rgba[middle + c]] / linear[as_second.rgba[middle + c]],
                    p.package->photos()[2].gain[c], 0.03);
}

TEST_F(EndToEndAtLength, PassersByAndHighlightsInSinglePhotosVanish) {
    SynthSpec spec = spec_named("small");
    spec.photos.count = 7;
    spec.photos.arc = 60;
    const fs::path folder = make(spec);
    const SceneInput scene = read_scene(discover(folder));
    const auto untouched = read_photo(scene.photos[3].file, {1000, 750}).rgba;
    {
        PrepareSettings never;
        never.effects[Effect::transients] = EffectChoice::off;
        Prepared clean(folder, dir / "clean.vantage"), off(folder, dir / "off.vantage", never);
        EXPECT_FALSE(effect_on(clean.package->scene(), Effect::transients));
        for (std::uint32_t i = 0; i < clean.photos.size(); ++i)
            EXPECT_EQ(clean.package->find(package::Type::weight_maps, i, weight_map_level)->checksum,
                      off.package->find(package::Type::weight_maps, i, weight_map_level)->checksum)
                << "a consistent scene should not be changed";
    }
    // Paint a person in front of the wall, and a flash reflection.
    const auto passer_by = [](int x, int y) { return std::hypot((x - 420) / 45.0, (y - 380) / 110.0) < 1; };
    const auto flash = [](int x, int y) { return std::hypot(x - 640, y - 300) < 40; };
    paint(scene.photos[2], {190, 30, 25}, passer_by);
    paint(scene.photos[4], {255, 255, 255}, flash);
    Prepared p = prepared(folder);
    ASSERT_TRUE(effect_on(p.package->scene(), Effect::transients));
    // The photo's view is rendered from the other photos.
    std::vector<std::uint32_t> others = p.photos;
    std::erase(others, 3u);
    const View view = view_of_photo(p.package->photos()[3], 1);
    RenderSettings model_only;
    model_only.background = ShowBackground::off;
    const double without = psnr(take_picture(*p.renderer, view, model_only, others, 1), untouched);
    RenderSettings all = model_only;
    all.weights.transient_mask = false;
    const double with = psnr(take_picture(*p.renderer, view, all, others, 1), untouched);
    // The same photos, but without the painted person.
    fs::remove_all(folder);
    Prepared clean = Prepared(make(spec), dir / "again.vantage");
    const double best = psnr(take_picture(*clean.renderer, view, model_only, others, 1), untouched);
    std::printf("with passers-by %.1f dB, with passers-by masked %.1f dB, without passers-by %.1f dB\n", with,
                without, best);
    EXPECT_GT(without, with + 1);
    EXPECT_GT(without, best - 0.1);
    // The person vanishes from the photo's own view, too.
    const Picture own = p.own_view(2, Blend::average);
    const std::size_t middle = 4 * (std::size_t(380) * 1000 + 420);
    EXPECT_LT(int(own.rgba[middle]) - int(own.rgba[middle + 1]), 100);
}

TEST_F(EndToEnd, MaskExcludesCoveredPixels) {
    SynthSpec spec = tiny();
    const fs::path folder = make(spec);
    const PhotoInput photo = read_scene(discover(folder)).photos[2];
    std::vector<std::uint8_t> mask(331 * 250, 255);
    for (std::size_t y = 100; y < 150; ++y)
        for (std::size_t x = 120; x < 200; ++x) mask[y * 331 + x] = 0;
    const fs::path file = folder / "images" / "0002.mask.png";
    image_files().write(file, 331, 250, 1, Sample::u8, std::as_bytes(std::span(mask)));
    Prepared p = prepared(folder);
    EXPECT_EQ(p.photos.size(), 5u) << "the mask should not be listed as a photo";
    EXPECT_TRUE(p.package->photos()[2].flags & package::photo_has_alpha);
    const View view = view_of_photo(p.package->photos()[2], 1);
    const Picture alone = take_picture(*p.renderer, view, {}, std::array{2u}, 1);
    const auto colored = [&](std::size_t x, std::size_t y) {
        return alone.rgba[4 * (y * 331 + x) + 3] == 255;
    };
    EXPECT_FALSE(colored(160, 125));
    EXPECT_TRUE(colored(160, 90));
    // A changed mask counts as a changed input; a mask of the wrong size is rejected.
    mask.assign(mask.size(), 255);
    image_files().write(file, 331, 250, 1, Sample::u8, std::as_bytes(std::span(mask)));
    PrepareSettings settings;
    settings.vertex_coordinates = true;
    const PrepareResult again =
        prepare(read_scene(discover(folder)), settings, p.file, [](const Progress&) {});
    EXPECT_EQ(again.stages[std::size_t(package::Stage::tiles)].made, 1u);
    image_files().write(file, 33, 25, 1, Sample::u8, std::as_bytes(std::span(mask).first(33 * 25)));
    const PrepareResult small =
        prepare(read_scene(discover(folder)), settings, p.file, [](const Progress&) {});
    ASSERT_EQ(small.skipped.size(), 1u);
    EXPECT_NE(small.skipped[0].why.find("its mask 0002.mask.png"), std::string::npos) << small.skipped[0].why;
}

TEST_F(EndToEnd, LensDistortionIsRemoved) {
    // The reference is the same scene photographed without distortion.
    SynthSpec spec = spec_named("hard");
    spec.photos.count = 3;
    Prepared p = prepared(make(spec));
    spec.lens = {};
    copy_scene(spec, dir / "straight");
    EXPECT_TRUE(lens_of(*p.package, 0).distorts());
    EXPECT_EQ(p.package->find(package::Type::tiles, 0)->form, package::Form::cells)
        << "the package should store the photo as taken";
    for (const std::uint32_t i : p.photos) {
        const PhotoInput& photo = p.scene.photos[i];
        const Picture best = p.own_view(i, Blend::best);
        const double straight =
            psnr(best, read_photo(dir / "straight" / "images" / photo.name, photo.decoded).rgba);
        std::printf("undistorted picture: %.1f dB against the photo taken without distortion\n", straight);
        EXPECT_GE(straight, 28.5);  // an offset of half a pixel would give 26
        EXPECT_LT(psnr(best, read_photo(photo.file, photo.decoded).rgba), 25);
    }
}

TEST_F(EndToEnd, BackgroundFillTheFrameAndLeaveTheMeshAlone) {
    VANTAGE_DATASET(set, "sceaux-small");
    const auto picture = [](Prepared& of, ShowBackground shown) {
        RenderSettings settings;
        settings.background = shown;
        std::vector<std::uint32_t> others = of.photos;
        std::erase(others, 4u);
        return take_picture(*of.renderer, view_of_photo(of.package->photos()[4], 1), settings, others, 1)
            .rgba;
    };
    std::vector<package::DirectoryEntry> chunks;
    std::vector<std::uint8_t> before;
    std::vector<std::uint32_t> triangles;  // at each pixel, from 1
    {
        PrepareSettings without;
        without.effects[Effect::background] = EffectChoice::off;
        without.vertex_coordinates = true;  // as prepared() does
        Prepared none(set, dir / "none.vantage", without);
        const auto directory = none.package->directory();
        chunks.assign(directory.begin(), directory.end());
        before = picture(none, ShowBackground::on);
        triangles = read_triangles(none.renderer->resources().targets);
    }
    Prepared p = prepared(set);
    ASSERT_TRUE(effect_on(p.package->scene(), Effect::background))
        << "trees, lawn and sky should produce a background";
    EXPECT_EQ(p.package->directory().size(), chunks.size() + 1);
    for (const package::DirectoryEntry& e : chunks) {
        const auto* same = p.package->find(package::Type(e.type), e.photo, e.level);
        const bool lists_effects =
            e.type == std::uint32_t(package::Type::meta) || e.type == std::uint32_t(package::Type::scene);
        ASSERT_TRUE(same);
        EXPECT_TRUE(lists_effects || same->checksum == e.checksum) << describe(*same, *p.package);
    }
    const auto off = picture(p, ShowBackground::off), on = picture(p, ShowBackground::on),
               dimmed = picture(p, ShowBackground::dimmed);
    const std::vector<std::uint32_t> hidden = read_background(*p.package)->hidden;
    std::size_t different = 0;
    for (std::size_t i = 0; i < triangles.size(); ++i)
        different += !std::equal(&off[4 * i], &off[4 * i] + 4, &before[4 * i]) &&
                     !std::ranges::binary_search(hidden, triangles[i] - 1);
    EXPECT_EQ(different, 0u)
        << "the frame should be the same as without the effect, except where the mesh shows the sky";
    std::size_t filled = 0, beside = 0, changed = 0, darker = 0;
    for (std::size_t i = 0; i < on.size(); i += 4) {
        filled += on[i + 3] == 255;
        if (off[i + 3] == 255) {
            changed +=
                !std::equal(&on[i], &on[i] + 3, &off[i]) || !std::equal(&on[i], &on[i] + 3, &dimmed[i]);
        } else {
            ++beside;
            darker += dimmed[i] + dimmed[i + 1] + dimmed[i + 2] <= on[i] + on[i + 1] + on[i + 2];
        }
    }
    EXPECT_GE(double(filled), 0.99 * double(on.size() / 4));
    EXPECT_GT(double(beside), 0.2 * double(on.size() / 4));
    // The clip planes differ, so the choice between two triangles at the same depth may differ.
    EXPECT_LE(double(changed), 1e-4 * double(on.size() / 4 - beside))
        << "pixels of the mesh should not change";
    EXPECT_EQ(darker, beside);
}
