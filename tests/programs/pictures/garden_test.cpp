// Compares the photographed background of a garden scene with the garden's geometry.
#include "pipeline/synth/garden.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "base/gl/context.h"
#include "pipeline/synth/cast_photo.h"
#include "pipeline/synth/synthesize.h"
#include "player/render/picture.h"
#include "scene/package/contents/background.h"
#include "tests/made_scenes.h"
#include "tests/programs/garden_spec.h"
#include "tests/temporary_folder.h"

using namespace vantage;

namespace {

class Garden : public TemporaryFolder {
  protected:
    /// Makes the photos and prepares the package.
    void SetUp() override {
        TemporaryFolder::SetUp();
        spec = garden_spec(4000, 600, 450);
        copy_scene(spec, dir / "scene");
        cameras = place_cameras(spec);
    }
    PackageReader prepared(const std::vector<std::string>& held_out) {
        PrepareSettings settings;
        settings.hold_out = held_out;
        return PackageReader(made_package(dir / "scene", settings));
    }
    SynthSpec spec;
    std::vector<NamedCamera> cameras;
};

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values.at(values.size() / 2);
}

bool shows(const RayScene& world, const Camera& camera, const Eigen::Vector3d& point) {
    const auto p = project(camera.intrinsics, camera.cam_from_world, point);
    const Eigen::Vector3d eye = camera.cam_from_world.center();
    return p && in_frame(camera.intrinsics, p->pixel) && !world.occluded(eye, point - eye, 0, 1 - 1e-3);
}

}  // namespace

TEST_F(Garden, BackgroundHaveItsDepth) {
    const PackageReader package = prepared({});
    const auto found = read_background(package);
    ASSERT_TRUE(found) << "lawn, hill and sky should produce a background";
    const RayScene world(build_world(spec).mesh), model(build_model(spec).mesh);
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    for (const NamedCamera& c : cameras) center += c.camera.cam_from_world.center() / double(cameras.size());
    const Eigen::Map<const Eigen::Vector3d> origin(package.scene().origin);
    std::vector<double> lawn, hill, sky;
    for (const Eigen::Vector3f& position : found->positions) {
        const Eigen::Vector3d place = position.cast<double>() + origin;
        const double distance = (place - center).norm();
        const Eigen::Vector3d direction = (place - center) / distance;
        if (model.first_hit(center, direction)) continue;
        const auto hit = world.first_hit(center, direction);
        const Eigen::Vector3d truth = center + (hit ? hit->distance : 1e5) * direction;
        const auto count = std::ranges::count_if(
            cameras, [&](const NamedCamera& c) { return shows(world, c.camera, truth); });
        if (count < 3) continue;
        if (!hit)
            sky.push_back(distance);
        else
            (truth.z() < 0 ? lawn : hill).push_back(std::abs(distance / hit->distance - 1));
    }
    ASSERT_GT(std::min({lawn.size(), hill.size(), sky.size()}), 100u);
    std::printf(
        "median error of the distance: lawn %.3f (%zu directions), hill %.3f (%zu); distance of the sky %.0f "
        "m (%zu)\n",
        median(lawn), lawn.size(), median(hill), hill.size(), median(sky), sky.size());
    EXPECT_LT(median(lawn), 0.03);
    EXPECT_LT(median(hill), 0.25);
    EXPECT_GT(median(sky), 200) << "the cameras are at most 16 m apart, so the sky should be far away";
}

TEST_F(Garden, FillsTheFrameOfAHeldOutPhoto) {
    const std::uint32_t photo = 4;
    const PackageReader package = prepared({cameras[photo].photo});
    const gl::HeadlessContext context;
    Renderer renderer(package, MemoryBudget{});
    std::vector<std::uint32_t> photos(cameras.size());
    std::iota(photos.begin(), photos.end(), 0u);
    std::erase(photos, photo);
    const SynthModel garden = build_world(spec);
    const RayScene world(garden.mesh), model(build_model(spec).mesh);
    const Camera& camera = cameras[photo].camera;
    const std::vector<std::uint8_t> truth = cast_photo(garden, world, camera, 1);
    const View view = view_of_photo(package.photos()[photo], 1);
    RenderSettings settings;
    settings.fill_holes = true;
    struct Errors {
        std::vector<double> beside;  ///< absolute, per channel
        std::size_t near = 0, railing = 0;
    };
    const auto errors = [&](ShowBackground shown) {
        settings.background = shown;
        const Picture p = take_picture(renderer, view, settings, photos, 1);
        Errors out;
        for (int y = 0; y < p.height; ++y)
            for (int x = 0; x < p.width; ++x) {
                const Intrinsics& k = camera.intrinsics;
                const Eigen::Vector3d eye = camera.cam_from_world.center(),
                                      ray = camera.cam_from_world.R.transpose() *
                                            Eigen::Vector3d((x + 0.5 - k.cx) / k.fx, (y + 0.5 - k.cy) / k.fy,
                                                            1);
                const auto hit = world.first_hit(eye, ray), scanned = model.first_hit(eye, ray);
                const std::size_t i = std::size_t(y) * std::size_t(p.width) + std::size_t(x);
                int largest = 0;
                for (std::size_t c = 0; c < 3; ++c)
                    largest = std::max(largest, std::abs(int(p.rgba[4 * i + c]) - int(truth[3 * i + c])));
                if (!scanned) out.beside.push_back(largest);
                if (!scanned || hit->distance > scanned->distance - 0.01) continue;
                ++out.railing;
                out.near += largest <= 10;
            }
        return out;
    };
    const Errors without = errors(ShowBackground::off), with = errors(ShowBackground::on);
    ASSERT_GT(with.beside.size(), 1000u);
    std::printf(
        "next to the mesh: median error %.0f of 255, without a background %.0f; railings: %.0f %% of %zu "
        "pixels are off by at most 10\n",
        median(with.beside), median(without.beside), 100.0 * double(with.near) / double(with.railing),
        with.railing);
    EXPECT_LT(median(with.beside), 20);
    EXPECT_GT(median(without.beside), 60);
}

TEST_F(Garden, NothingIsDarkWhileOnePhotoReplacesAnother) {
    const PackageReader package = prepared({});
    const gl::HeadlessContext context;
    Renderer renderer(package, MemoryBudget{});
    const std::vector<std::uint32_t> photos{1, 7};
    RenderSettings settings;
    settings.fill_holes = true;
    settings.loading = Loading::repeatable;
    settings.choice = Choice::nearest, settings.photos = 1;
    const View from = view_of_photo(package.photos()[1], 0.5), to = view_of_photo(package.photos()[7], 0.5);
    const auto drawn = [&](const View& view, double start, int frames) {
        for (int i = 0; i < frames; ++i) renderer.draw(view, settings, photos, {}, start + 0.1 * i);
        return shown_picture(renderer, view, settings);
    };
    drawn(from, 0, 10);
    const Picture between = drawn(to, 1, 1), after = drawn(to, 2, 10);
    settings.loading = Loading::complete;
    const std::vector<std::uint32_t> replaced{photos[0]};
    const Picture before = take_picture(renderer, to, settings, replaced, 1);
    EXPECT_NE(between.rgba, before.rgba);
    EXPECT_NE(between.rgba, after.rgba);
    const auto light = [](const Picture& p, std::size_t pixel) {
        return int(p.rgba[4 * pixel]) + p.rgba[4 * pixel + 1] + p.rgba[4 * pixel + 2];
    };
    const std::size_t pixels = after.rgba.size() / 4;
    std::size_t darker = 0;
    for (std::size_t i = 0; i < pixels; ++i)
        darker += light(between, i) < std::min(light(before, i), light(after, i)) - 30;
    EXPECT_LT(double(darker), 0.005 * double(pixels));
}
