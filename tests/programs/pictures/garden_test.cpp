// Compares the photographed background of a garden scene with the garden's geometry.
#include "pipeline/synth/garden.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <optional>

#include "base/gl/context.h"
#include "pipeline/synth/cast_photo.h"
#include "pipeline/synth/synthesize.h"
#include "player/render/picture.h"
#include "player/survey/ray_cast.h"
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

TEST_F(Garden, HiddenBallsLackModelAndPhotosUntilTheyAreShownAgain) {
    const PackageReader package = prepared({});
    const gl::HeadlessContext context;
    Renderer renderer(package, MemoryBudget{});
    std::vector<std::uint32_t> photos(cameras.size());
    std::iota(photos.begin(), photos.end(), 0u);
    View view = view_of_photo(package.photos()[3], 0.5);
    view.cam_from_origin.t.x() += 3;  // away from the camera, at which its own photo is shown
    const PlanScene& scene = renderer.scene();
    const auto place = [&](std::size_t pixel) -> std::optional<Eigen::Vector3d> {
        const int width = view.intrinsics.width;
        const auto hit = first_hit(
            scene, ray_through(view, {double(int(pixel) % width) + 0.5, double(int(pixel) / width) + 0.5}));
        return hit ? std::optional(hit->position) : std::nullopt;
    };
    RenderSettings settings;
    const auto picture = [&](ShowBackground background) {
        settings.background = background;
        return take_picture(renderer, view, settings, photos, 1);
    };
    const Picture model = picture(ShowBackground::off), whole = picture(ShowBackground::on);
    const std::size_t pixels = model.rgba.size() / 4;
    std::vector<std::optional<Eigen::Vector3d>> places;
    std::vector<Eigen::Vector3d> found;
    for (std::size_t i = 0; i < pixels; ++i)
        if (const auto at = places.emplace_back(place(i))) found.push_back(*at);
    ASSERT_GT(found.size(), pixels / 20) << "the model is in view";

    const Ball on_model{found[found.size() / 2], 0.8};
    renderer.hide({{on_model}});
    const Picture without = picture(ShowBackground::off);
    std::size_t inside = 0, kept = 0, outside = 0, changed = 0;
    for (std::size_t i = 0; i < pixels; ++i) {
        if (!places[i]) continue;
        const double away = (*places[i] - on_model.center).norm() / on_model.radius;
        const auto behind = place(i);
        if (away < 0.7)
            ++inside, kept += behind && (*behind - on_model.center).norm() < 0.7 * on_model.radius;
        if (away < 0.7 && !behind) kept += without.rgba[4 * i + 3] > 0;
        if (away > 1.5) ++outside, changed += std::abs(int(model.rgba[4 * i]) - int(without.rgba[4 * i])) > 3;
    }
    ASSERT_GT(inside, 100u);
    EXPECT_LT(double(kept), 0.02 * double(inside));
    EXPECT_LT(double(changed), 0.01 * double(outside));

    // A ball on the sphere of the background, where the view sees the lawn.
    const auto background = read_background(package);
    ASSERT_TRUE(background);
    std::optional<std::size_t> on_lawn;
    for (std::size_t i = pixels * 9 / 10; i < pixels && !on_lawn; ++i)
        if (!places[i]) on_lawn = i;
    ASSERT_TRUE(on_lawn);
    const auto direction = [&](std::size_t i) -> Eigen::Vector3d {
        return ray_through(view, {double(i % std::size_t(view.intrinsics.width)),
                                  double(i / std::size_t(view.intrinsics.width))})
            .along.normalized();
    };
    const Eigen::Vector3d eye = ray_through(view, {0, 0}).from;
    const auto nearest = std::ranges::max(background->positions, {}, [&](const Eigen::Vector3f& p) {
        return (p.cast<double>() - eye).normalized().dot(direction(*on_lawn));
    });
    const Ball on_background{nearest.cast<double>(), 0.15 * (nearest.cast<double>() - eye).norm()};
    renderer.hide({{on_background}});
    const Picture calm = picture(ShowBackground::on);
    double before = 0, after = 0;
    std::size_t far = 0, far_changed = 0, near = 0;
    for (std::size_t i = 1; i < pixels; ++i) {
        const double angle =
            std::acos(std::clamp(direction(i).dot((on_background.center - eye).normalized()), -1.0, 1.0));
        const auto step = [&](const Picture& p) {
            return std::abs(int(p.rgba[4 * i + 1]) - int(p.rgba[4 * i - 3]));
        };
        if (!places[i] && !places[i - 1] && angle < 0.08) ++near, before += step(whole), after += step(calm);
        if (angle > 0.5) ++far, far_changed += std::abs(int(whole.rgba[4 * i]) - int(calm.rgba[4 * i])) > 3;
    }
    std::printf(
        "hidden: %zu of %zu pixels of the model remain; steps on the lawn %.1f, hidden %.1f (%zu pixels)\n",
        kept, inside, before / double(near), after / double(near), near);
    ASSERT_GT(near, 100u);
    EXPECT_LT(after, 0.3 * before) << "a hidden piece of the background is smooth";
    EXPECT_LT(double(far_changed), 0.01 * double(far));

    renderer.hide({});
    const auto differs = [&](const Picture& a, const Picture& b) {
        std::size_t out = 0;
        for (std::size_t i = 0; i < 4 * pixels; ++i) out += std::abs(int(a.rgba[i]) - int(b.rgba[i])) > 3;
        return double(out) / double(4 * pixels);
    };
    EXPECT_LT(differs(picture(ShowBackground::off), model), 0.001);
    EXPECT_LT(differs(picture(ShowBackground::on), whole), 0.001);
}
