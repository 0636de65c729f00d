// Compares the lighting of the geometry with Phong's model where rays hit flat walls.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/gl/context.h"
#include "base/values/srgb.h"
#include "player/render/picture.h"
#include "shaders/contract.h"
#include "tests/made_scenes.h"
#include "tests/temporary_folder.h"

using namespace vantage;

namespace {

class LightOnGeometry : public TemporaryFolder {
  protected:
    void SetUp() override {
        TemporaryFolder::SetUp();
        copy_scene(spec_named("tiny"), dir / "scene");
        copy_package(dir / "scene", {}, dir / "scene.vantage");
    }
    Picture taken(Renderer& renderer, const RenderSettings& settings) const {
        std::vector<std::uint32_t> photos(renderer.package().photos().size());
        std::iota(photos.begin(), photos.end(), 0u);
        return take_picture(renderer, view_of_photo(renderer.package().photos()[1], 0.5), settings, photos,
                            1);
    }
};

/// A pixel on a flat triangle: the unit normal toward the viewer and the direction to the viewer. Both are in
/// the viewer's axes (right, up, toward the viewer).
struct Flat {
    std::size_t pixel;
    Eigen::Vector3d normal, viewer;
};

std::vector<Flat> flat_pixels(const Renderer& renderer) {
    const PlanScene& scene = renderer.scene();
    const auto normals = renderer.package().records<Eigen::Vector3f>(package::Type::normals);
    const View view = view_of_photo(renderer.package().photos()[1], 0.5);
    const Eigen::Matrix3d up_and_back = Eigen::Vector3d(1, -1, -1).asDiagonal();
    const std::vector<std::uint32_t> triangles = read_triangles(renderer.resources().targets);
    std::vector<Flat> out;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (triangles[i] == 0) continue;
        const std::uint32_t* v = &scene.indices[3 * (triangles[i] - 1)];
        const auto at = [&](int c) { return scene.positions[v[c]].cast<double>().eval(); };
        const Eigen::Vector3d normal = (at(1) - at(0)).cross(at(2) - at(0)).normalized();
        bool flat = true;
        for (int c = 0; c < 3; ++c) flat &= std::abs(normals[v[c]].cast<double>().dot(normal)) > 0.99999;
        if (!flat) continue;
        const Intrinsics& k = view.intrinsics;
        const auto width = std::size_t(k.width);
        const Eigen::Vector3d ray((double(i % width) + 0.5 - k.cx) / k.fx,
                                  (double(i / width) + 0.5 - k.cy) / k.fy, 1);
        Flat f{i, up_and_back * view.cam_from_origin.R * normal, -(up_and_back * ray).normalized()};
        if (f.normal.dot(f.viewer) < 0) f.normal = -f.normal;
        if (f.normal.dot(f.viewer) > 0.05) out.push_back(f);
    }
    return out;
}

/// The brightness relative to a surface that faces the viewer, clamped to 3.
double phong(const Flat& f, const Eigen::Vector3d& to_light, double facing_the_viewer) {
    const auto of = [](double facing, double glint) {
        return shader::light_ambient + shader::light_diffuse * std::max(facing, 0.0) +
               shader::light_specular * (facing > 0 ? std::pow(std::max(glint, 0.0), 24) : 0);
    };
    const double facing = f.normal.dot(to_light);
    const Eigen::Vector3d mirrored = 2 * facing * f.normal - to_light;
    return std::min(of(facing, mirrored.dot(f.viewer)) / of(facing_the_viewer, facing_the_viewer), 3.0);
}

int code(double linear) { return int(std::lround(255 * srgb_from_linear(std::clamp(linear, 0.0, 1.0)))); }

}  // namespace

TEST_F(LightOnGeometry, HasTheBrightnessOfPhongsModel) {
    const PackageReader package(dir / "scene.vantage");
    const gl::HeadlessContext context;
    Renderer renderer(package, MemoryBudget{});
    RenderSettings settings;
    const Picture photos = taken(renderer, settings);
    const std::vector<Flat> flat = flat_pixels(renderer);
    ASSERT_GT(flat.size(), 1000u);
    for (const auto& [azimuth, elevation] : {std::pair(135.0, 15.0), {0.0, 40.0}, {250.0, 5.0}}) {
        settings.light = {.light = Light::raking, .azimuth = azimuth, .elevation = elevation};
        const Picture raking = taken(renderer, settings);
        settings.light.on_photos = true;
        const Picture on_photos = taken(renderer, settings);
        const double a = azimuth * std::numbers::pi / 180, e = elevation * std::numbers::pi / 180;
        const Eigen::Vector3d to_light(std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e));
        std::size_t wrong = 0, wrong_on_photos = 0;
        for (const Flat& f : flat) {
            const double light = phong(f, to_light, std::sin(e));
            wrong += std::abs(raking.rgba[4 * f.pixel] - code(shader::light_gray * light)) > 2;
            for (std::size_t c = 0; c < 3; ++c) {
                const std::uint8_t was = photos.rgba[4 * f.pixel + c];
                if (was < 10) continue;  // rounded to 8 bits
                const double linear = linear_from_srgb(was / 255.0);
                wrong_on_photos += std::abs(on_photos.rgba[4 * f.pixel + c] - code(light * linear)) > 4;
            }
        }
        EXPECT_LT(double(wrong), 0.002 * double(flat.size())) << azimuth << ' ' << elevation;
        EXPECT_LT(double(wrong_on_photos), 0.005 * double(flat.size())) << azimuth << ' ' << elevation;
    }
}

TEST_F(LightOnGeometry, NormalsAreDirectionsAsColors) {
    const PackageReader package(dir / "scene.vantage");
    const gl::HeadlessContext context;
    Renderer renderer(package, MemoryBudget{});
    RenderSettings settings;
    settings.light.light = Light::normals;
    const Picture picture = taken(renderer, settings);
    const std::vector<Flat> flat = flat_pixels(renderer);
    ASSERT_GT(flat.size(), 1000u);
    std::size_t wrong = 0;
    for (const Flat& f : flat)
        for (int c = 0; c < 3; ++c)
            wrong += std::abs(picture.rgba[4 * f.pixel + std::size_t(c)] - 255 * (f.normal[c] + 1) / 2) > 4;
    EXPECT_LT(double(wrong), 0.002 * double(flat.size()));
}

TEST_F(LightOnGeometry, ALampAtTheViewerShowsWhatFacesItBrightest) {
    const PackageReader package(dir / "scene.vantage");
    const gl::HeadlessContext context;
    Renderer renderer(package, MemoryBudget{});
    RenderSettings settings;
    settings.light.light = Light::lamp;
    const Picture picture = taken(renderer, settings);
    std::size_t wrong = 0;
    const std::vector<Flat> flat = flat_pixels(renderer);
    for (const Flat& f : flat)
        wrong += std::abs(picture.rgba[4 * f.pixel] - code(shader::light_gray * phong(f, f.viewer, 1))) > 2;
    EXPECT_LT(double(wrong), 0.002 * double(flat.size()));
}

TEST_F(LightOnGeometry, TheWireframeIsWhereTrianglesMeet) {
    const PackageReader package(dir / "scene.vantage");
    const gl::HeadlessContext context;
    Renderer renderer(package, MemoryBudget{});
    RenderSettings settings;
    const Picture without = taken(renderer, settings);
    settings.light.wireframe = true;
    const Picture with = taken(renderer, settings);
    const std::vector<std::uint32_t> triangles = read_triangles(renderer.resources().targets);
    const auto width = std::size_t(with.width);
    std::size_t borders = 0, wrong = 0;
    for (std::size_t y = 0; y + 1 < std::size_t(with.height); ++y)
        for (std::size_t x = 0; x + 1 < width; ++x) {
            const std::size_t i = y * width + x;
            const bool border = triangles[i] != 0 &&
                                (triangles[i] != triangles[i + 1] || triangles[i] != triangles[i + width]);
            const bool changed = !std::equal(&with.rgba[4 * i], &with.rgba[4 * i + 4], &without.rgba[4 * i]);
            borders += border;
            wrong += border != changed;
        }
    EXPECT_GT(borders, 1000u);
    EXPECT_EQ(wrong, 0u);
    settings.light.wireframe = false;
    EXPECT_EQ(taken(renderer, settings).rgba, without.rgba);
}

TEST_F(LightOnGeometry, ThePhotosAreAsBeforeWhenItIsOffAgain) {
    const PackageReader package(dir / "scene.vantage");
    const gl::HeadlessContext context;
    Renderer renderer(package, MemoryBudget{});
    RenderSettings settings;
    const Picture before = taken(renderer, settings);
    settings.light.light = Light::raking;
    EXPECT_NE(taken(renderer, settings).rgba, before.rgba);
    settings.light.light = Light::photos;
    EXPECT_EQ(taken(renderer, settings).rgba, before.rgba);
}
