// Compares the lighting of the geometry with Phong's model where rays hit flat walls, and cast shadows with
// rays to the light.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <bit>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/gl/context.h"
#include "base/values/srgb.h"
#include "player/render/picture.h"
#include "player/survey/ray_cast.h"
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

/// A pixel on a flat triangle: the unit normal toward the viewer and the direction to the viewer, both in the
/// viewer's axes (right, up, toward the viewer), and the position in the scene.
struct Flat {
    std::size_t pixel;
    Eigen::Vector3d normal, viewer, position;
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
        const Eigen::Vector3d eye = view.cam_from_origin.center(),
                              along = view.cam_from_origin.R.transpose() * ray;
        Flat f{i, up_and_back * view.cam_from_origin.R * normal, -(up_and_back * ray).normalized(),
               eye + along * normal.dot(at(0) - eye) / normal.dot(along)};
        if (f.normal.dot(f.viewer) < 0) f.normal = -f.normal;
        if (f.normal.dot(f.viewer) > 0.05) out.push_back(f);
    }
    return out;
}

/// Whether the mesh is between a pixel and the light, whose direction is in the viewer's axes; nullopt within
/// a few texels of a shadow map of the border of a shadow.
std::optional<bool> in_shadow(const Renderer& renderer, const Flat& f, const Eigen::Vector3d& to_light) {
    const PlanScene& scene = renderer.scene();
    const View view = view_of_photo(renderer.package().photos()[1], 0.5);
    const Eigen::Matrix3d scene_from_viewer =
        view.cam_from_origin.R.transpose() * Eigen::Vector3d(1, -1, -1).asDiagonal();
    const Eigen::Vector3d light = scene_from_viewer * to_light, normal = scene_from_viewer * f.normal;
    const unsigned side = std::bit_floor(unsigned(std::max(view.intrinsics.width, view.intrinsics.height)));
    const double reach = 4 * scene.size / side;
    const Eigen::Vector3d across = normal.unitOrthogonal(), other = normal.cross(across);
    std::optional<bool> first;
    for (const double by : {1e-4 * scene.size, 0.25 * reach, 0.5 * reach, reach})
        for (const auto& [a, b] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
            const Eigen::Vector3d from = f.position + by * (0.5 * normal + a * across + b * other);
            const bool hit =
                first_hit(scene, {from, light}, {1e-9 * scene.size, 10 * scene.size}).has_value();
            if (first.value_or(hit) != hit) return std::nullopt;
            first = hit;
        }
    return first;
}

/// The brightness relative to a surface that faces the viewer, clamped to 3; `shaded`: in a cast shadow.
double phong(const Flat& f, const Eigen::Vector3d& to_light, double facing_the_viewer, bool shaded = false) {
    const auto of = [](double facing, double glint, double share = 1) {
        return shader::light_ambient +
               share * (shader::light_diffuse * std::max(facing, 0.0) +
                        shader::light_specular * (facing > 0 ? std::pow(std::max(glint, 0.0), 24) : 0));
    };
    const double facing = f.normal.dot(to_light);
    const Eigen::Vector3d mirrored = 2 * facing * f.normal - to_light;
    return std::min(of(facing, mirrored.dot(f.viewer), shaded ? shader::light_in_shadow : 1) /
                        of(facing_the_viewer, facing_the_viewer),
                    3.0);
}

int code(double linear) { return int(std::lround(255 * srgb_from_linear(std::clamp(linear, 0.0, 1.0)))); }

}  // namespace

TEST_F(LightOnGeometry, HasTheBrightnessOfPhongsModelAndCastsShadows) {
    const PackageReader package(dir / "scene.vantage");
    const gl::HeadlessContext context;
    Renderer renderer(package, MemoryBudget{});
    RenderSettings settings;
    const Picture photos = taken(renderer, settings);
    const std::vector<Flat> flat = flat_pixels(renderer);
    ASSERT_GT(flat.size(), 1000u);
    std::size_t shaded = 0;
    for (const auto& [azimuth, elevation] : {std::pair(135.0, 15.0), {0.0, 40.0}, {250.0, 5.0}}) {
        settings.light = {.light = Light::raking, .azimuth = azimuth, .elevation = elevation};
        const Picture raking = taken(renderer, settings);
        settings.light.on_photos = true;
        const Picture on_photos = taken(renderer, settings);
        const double a = azimuth * std::numbers::pi / 180, e = elevation * std::numbers::pi / 180;
        const Eigen::Vector3d to_light(std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e));
        std::size_t wrong = 0, wrong_on_photos = 0, certain = 0;
        for (const Flat& f : flat) {
            if (f.pixel % 11 != 0) continue;  // rays are slow
            const bool away = f.normal.dot(to_light) <= 0;
            const std::optional<bool> shadow = away ? false : in_shadow(renderer, f, to_light);
            if (!shadow) continue;
            ++certain;
            shaded += *shadow;
            const double light = phong(f, to_light, std::sin(e), *shadow);
            wrong += std::abs(raking.rgba[4 * f.pixel] - code(shader::light_gray * light)) > 2;
            for (std::size_t c = 0; c < 3; ++c) {
                const std::uint8_t was = photos.rgba[4 * f.pixel + c];
                if (was < 10) continue;  // rounded to 8 bits
                const double linear = linear_from_srgb(was / 255.0);
                wrong_on_photos += std::abs(on_photos.rgba[4 * f.pixel + c] - code(light * linear)) > 4;
            }
        }
        EXPECT_LT(double(wrong), 0.002 * double(certain)) << azimuth << ' ' << elevation;
        EXPECT_LT(double(wrong_on_photos), 0.005 * double(certain)) << azimuth << ' ' << elevation;
        EXPECT_GT(certain, flat.size() / 22) << azimuth << ' ' << elevation;
    }
    EXPECT_GT(shaded, 100u);
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
