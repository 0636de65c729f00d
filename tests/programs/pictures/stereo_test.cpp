// Stereo pictures.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <string>

#include "base/gl/context.h"
#include "player/composition/stereo_picture.h"
#include "player/render/timing/pace.h"
#include "tests/made_scenes.h"
#include "tests/programs/garden_package.h"

using namespace vantage;
namespace fs = std::filesystem;

namespace {

/// Tests stereo pictures of a package with a background.
class StereoPictures : public GardenPackage {
  protected:
    void SetUp() override {
        GardenPackage::SetUp();
        make_package({{Effect::background, EffectChoice::on}});
    }
    Picture offscreen(const std::string& name, const std::string& options) const {
        return read_png(GardenPackage::offscreen(name, options));
    }
};
class StereoPicturesAtLength : public StereoPictures {};

/// A part of a picture.
Picture part(const Picture& p, int left, int top, int width, int height) {
    Picture out{width, height, {}, {}};
    for (int y = 0; y < height; ++y) {
        const auto row = p.rgba.begin() + std::ptrdiff_t(4) * ((top + y) * p.width + left);
        out.rgba.insert(out.rgba.end(), row, row + std::ptrdiff_t(4) * width);
    }
    return out;
}

struct Pixel {
    double r, g, b;
};
Pixel light_at(const Picture& p, std::size_t i) {
    const auto light = [&](std::size_t c) {
        const double s = p.rgba[4 * i + c] / 255.0;
        return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
    };
    return {light(0), light(1), light(2)};
}
double srgb_code(double light) {
    const double l = std::clamp(light, 0.0, 1.0);
    return 255 * (l <= 0.0031308 ? 12.92 * l : 1.055 * std::pow(l, 1 / 2.4) - 0.055);
}

/// The mean difference of 8-bit values between the upper parts of two pictures of the same width.
double difference_of_frames(const Picture& a, const Picture& b) {
    double sum = 0;
    for (std::size_t i = 0; i < std::min(a.rgba.size(), b.rgba.size()); ++i)
        sum += std::abs(int(a.rgba[i]) - int(b.rgba[i]));
    return sum / double(std::min(a.rgba.size(), b.rgba.size()));
}

}  // namespace

TEST_F(StereoPicturesAtLength, AreTwoSinglePicturesToTheBit) {
    const PackageReader package(file);
    const gl::HeadlessContext context;
    const View middle = view_of_photo(package.photos()[2], 0.7);
    const double apart = 0.3, convergence = 5;
    // The reference is computed by hand: the cameras are moved sideways, and the pictures are shifted so that
    // points at the convergence distance coincide.
    View left = middle, right = middle;
    left.cam_from_origin.t.x() += 0.15, right.cam_from_origin.t.x() -= 0.15;
    left.intrinsics.cx -= middle.intrinsics.fx * 0.15 / 5,
        right.intrinsics.cx += middle.intrinsics.fx * 0.15 / 5;
    for (const int blended : {0, 3})
        for (const int side : {1, 2}) {
            RenderSettings settings;
            settings.photos = blended;
            settings.fill_holes = true;
            const auto single = [&](const View& view) {
                Renderer renderer(package, MemoryBudget{});
                for (const PixelSample sample : single_samples(side))  // as for stereo
                    renderer.draw(view, settings, all(package), sample, 0);
                return shown_picture(renderer, view, settings);
            };
            Renderer renderer(package, MemoryBudget{});
            ObjectSet objects(renderer, {{"garden", file, {}, true}}, MemoryBudget{});
            StereoPicture stereo;
            const auto eyes = eye_views(middle, {.distance = apart, .convergence = convergence}, 1);
            const Picture both =
                take_picture(objects, stereo, StereoMode::side_by_side, eyes, {settings, all(package), side});
            const int w = middle.intrinsics.width, h = middle.intrinsics.height;
            ASSERT_EQ(both.width, 2 * w);
            ASSERT_EQ(both.height, h);
            EXPECT_EQ(part(both, 0, 0, w, h).rgba, single(left).rgba) << blended << " photos";
            EXPECT_EQ(part(both, w, 0, w, h).rgba, single(right).rgba) << blended << " photos";
            EXPECT_NE(part(both, 0, 0, w, h).rgba, part(both, w, 0, w, h).rgba);
        }
}

TEST_F(StereoPicturesAtLength, AreTheSameHoweverTheirSurfaceIsDrawn) {
    copy_scene(garden_spec(60000, 400, 300), dir / "fine");
    PrepareSettings prepared;
    prepared.effects[Effect::background] = EffectChoice::on;
    const fs::path fine = made_package(dir / "fine", prepared);  // fine enough for a coarse mesh
    const PackageReader package(fine);
    const gl::HeadlessContext context;
    // The eyes' axes diverge, as in some headsets.
    auto eyes = eye_views(scaled(view_of_photo(package.photos()[1], 0.8), 0.5),
                          {.distance = 0.3, .convergence = 5}, 1);
    for (const int i : {0, 1}) {
        Pose& pose = eyes[std::size_t(i)].cam_from_origin;
        const Eigen::Matrix3d apart =
            Eigen::AngleAxisd(i ? -0.1 : 0.1, Eigen::Vector3d::UnitY()).toRotationMatrix();
        pose = {apart * pose.R, apart * pose.t};
    }
    std::map<std::string, RenderSettings> cases;
    for (const char* name : {"plain", "raking", "normals", "cut", "field", "reduced", "by model"})
        cases[name].photos = 4, cases[name].fill_holes = true;
    cases["raking"].light = {.light = Light::raking, .on_photos = true, .wireframe = true};
    cases["normals"].light.light = Light::normals;
    cases["cut"].sections = {{Eigen::Vector3d::UnitX(), 0.2}, {Eigen::Vector3d::UnitY(), 0.1}};
    cases["field"].field.index = 0;
    cases["reduced"].reduced = true;
    cases["reduced"].photos = 0;  // with fewer, one eye alone may select other photos than both together
    Renderer renderer(package, MemoryBudget{});
    renderer.planner().coarsen(true);
    ObjectSet objects(renderer, {{"garden", fine, {}, true}}, MemoryBudget{});
    StereoPicture stereo;
    const int w = eyes[0].intrinsics.width, h = eyes[0].intrinsics.height;
    for (auto& [name, settings] : cases)
        for (const EyeSurfaces surfaces :
             {EyeSurfaces::in_turn, EyeSurfaces::overlapped, EyeSurfaces::at_once}) {
            renderer.resources().trials = {.eye_surfaces = surfaces, .by_triangle = name != "by model"};
            const Picture both =
                take_picture(objects, stereo, StereoMode::side_by_side, eyes, {settings, all(package), 1});
            for (const int i : {0, 1}) {
                const View& eye = eyes[std::size_t(i)];
                EXPECT_EQ(part(both, i * w, 0, w, h).rgba,
                          take_picture(renderer, eye, settings, all(package), 1).rgba)
                    << name << ", surfaces " << int(surfaces) << ", eye " << i;
            }
        }
    if (!epoxy_has_gl_extension("GL_ARB_shader_viewport_layer_array"))
        GTEST_SKIP() << "this driver does not support one pass for both eyes";
}

TEST_F(StereoPicturesAtLength, OfAWindowShareTheirPhotosAndUploadEachTileOnce) {
    const PackageReader package(file);
    const gl::HeadlessContext context;
    const View middle = view_of_photo(package.photos()[2], 0.7);
    RenderSettings settings;
    settings.photos = 2;
    settings.loading = Loading::repeatable;
    const auto uploaded = [&](std::span<const View> eyes) {
        Renderer renderer(package, MemoryBudget{});
        ObjectSet objects(renderer, {{"garden", file, {}, true}}, MemoryBudget{});
        for (int frame = 0; frame < 8; ++frame)
            objects.draw_eyes({eyes, settings, all(package), {}, double(frame)}, [](auto) {});
        return objects.streamed().bytes;
    };
    const auto eyes = eye_views(middle, {}, 5);
    const auto one = uploaded(std::span(eyes).first(1)), two = uploaded(eyes);
    EXPECT_GT(one, 0u);
    EXPECT_LT(double(two), 1.2 * double(one));
}

TEST_F(StereoPictures, OfTheProgramAreArrangedAsAsked) {
    const std::string view = "--photo 0002 --scale 0.5 --eye-separation 0.4 --convergence 6 --stereo ";
    const Picture beside = offscreen("beside", view + "side-by-side");
    const int w = beside.width / 2, h = beside.height;
    const Picture left = part(beside, 0, 0, w, h), right = part(beside, w, 0, w, h);
    EXPECT_NE(left.rgba, right.rgba);

    const Picture above = offscreen("above", view + "over-under");
    EXPECT_EQ(above.width, w);
    EXPECT_EQ(part(above, 0, 0, w, h).rgba, left.rgba);
    EXPECT_EQ(part(above, 0, h, w, h).rgba, right.rgba);

    const Picture board = offscreen("board", view + "checkerboard");
    ASSERT_EQ(board.rgba.size(), left.rgba.size());
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
            const Picture& eye = (x + y) % 2 ? right : left;
            const auto at = std::size_t(4 * (y * w + x));
            ASSERT_TRUE(std::equal(&eye.rgba[at], &eye.rgba[at] + 4, &board.rgba[at])) << x << ", " << y;
        }

    // Dubois's matrices for red-cyan glasses, applied to linear light.
    const Picture glasses = offscreen("glasses", view + "anaglyph");
    ASSERT_EQ(glasses.rgba.size(), left.rgba.size());
    double most = 0;
    for (std::size_t i = 0; i < left.rgba.size() / 4; ++i) {
        const Pixel l = light_at(left, i), r = light_at(right, i);
        const double expected[] = {
            0.456 * l.r + 0.500 * l.g + 0.176 * l.b - 0.043 * r.r - 0.088 * r.g - 0.002 * r.b,
            -0.040 * l.r - 0.038 * l.g - 0.016 * l.b + 0.378 * r.r + 0.734 * r.g - 0.018 * r.b,
            -0.015 * l.r - 0.021 * l.g - 0.005 * l.b - 0.072 * r.r - 0.113 * r.g + 1.226 * r.b};
        for (std::size_t c = 0; c < 3; ++c)
            most = std::max(most, std::abs(srgb_code(expected[c]) - glasses.rgba[4 * i + c]));
    }
    EXPECT_LE(most, 1) << "codes";
}

TEST_F(StereoPicturesAtLength, OfAWindowAreThoseOfTwoEyes) {
    if (std::system("command -v xvfb-run >/dev/null") != 0) GTEST_SKIP() << "no X server available";
    const auto window = [&](const std::string& name, const std::string& options) {
        const fs::path png = dir / (name + ".png");
        const std::string command = "env HOME=" + dir.string() + " xvfb-run -a -s '-screen 0 1280x1024x24' " +
                                    VANTAGE_PLAYER + " " + file.string() +
                                    " --no-saved-settings --quiet --frames 60 " + options + " --screenshot " +
                                    png.string();
        EXPECT_EQ(std::system(command.c_str()), 0) << options;
        return read_png(png);
    };
    // The area of the window that has no panels.
    constexpr int w = 400, h = 250;
    const Picture mono = part(window("mono", "--size 400x400"), 0, 0, w, h);
    const Picture both = window("both", "--size 800x400 --stereo side-by-side --eye-separation 0.3");
    const Picture left = part(both, 0, 0, w, h), right = part(both, w, 0, w, h);
    EXPECT_GT(difference_of_frames(left, right), 0.5) << "the eyes should be at different positions";
    EXPECT_LT(difference_of_frames(left, mono), 10);
    EXPECT_LT(difference_of_frames(right, mono), 10);
    const Picture above = window("above", "--size 400x800 --stereo over-under --eye-separation 0.3");
    EXPECT_LT(difference_of_frames(part(above, 0, 0, w, h), part(above, 0, 400, w, h)), 10);
}
