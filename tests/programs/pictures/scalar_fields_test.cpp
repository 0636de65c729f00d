// Compares scalar fields on the model with the values at ray intersections.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "base/gl/context.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/mesh/ray_scene.h"
#include "pipeline/mesh/subdivide.h"
#include "pipeline/prepare/prepare.h"
#include "pipeline/run/until_stopped.h"
#include "pipeline/synth/synthesize.h"
#include "player/interface/overlays/value_at_pixel.h"
#include "player/render/picture.h"
#include "scene/package/contents/color_map.h"
#include "scene/package/contents/photo_fields.h"
#include "scene/package/package_shape.h"
#include "tests/made_scenes.h"
#include "tests/temporary_folder.h"

using namespace vantage;

namespace {

constexpr float none = std::numeric_limits<float>::quiet_NaN();

/// A small building, whose mesh has scalar fields, and its package.
class ScalarFields : public TemporaryFolder {
  protected:
    void SetUp() override {
        TemporaryFolder::SetUp();
        SynthSpec spec = spec_named("tiny");
        copy_scene(spec, dir / "scene");
        scene = read_scene(discover(dir / "scene"));
        subdivide_large_triangles(scene.mesh, main_box(scene.mesh));
    }
    /// A field that is linear in the position, so that its value is known everywhere on the surface.
    static double height(const Eigen::Vector3d& p) { return p.z() + 0.25 * p.x(); }

    void add(const std::string& name, const std::function<double(const Eigen::Vector3d&)>& value) {
        VertexField field{name, {}};
        for (const Eigen::Vector3d& p : scene.mesh.positions) field.values.push_back(float(value(p)));
        scene.mesh.scalars.push_back(field);
    }
    PackageReader prepared(EffectChoice choice = EffectChoice::automatic) {
        PrepareSettings settings;
        settings.effects[Effect::scalar_fields] = choice;
        const std::filesystem::path file = dir / "scene.vantage";
        std::filesystem::remove(file);
        prepare(scene, settings, file, [](const Progress&) {});
        return PackageReader(file);
    }
    static std::vector<std::uint32_t> all(const PackageReader& package) {
        std::vector<std::uint32_t> photos(package.photos().size());
        std::iota(photos.begin(), photos.end(), 0u);
        return photos;
    }
    SceneInput scene;
};

/// The intersections of the pixels' rays with the mesh, except next to edges in the picture.
class Rays {
  public:
    Rays(const Mesh& mesh, const Eigen::Vector3d& origin, const View& view)
        : scene_(mesh), origin_(origin), view_(view) {}

    std::optional<Eigen::Vector3d> surface(double x, double y) const {
        const auto middle = hit(x, y);
        if (!middle) return {};
        const Eigen::Vector3d across = *middle - eye();
        for (const auto& [dx, dy] : {std::pair(-1.0, 0.0), {1.0, 0.0}, {0.0, -1.0}, {0.0, 1.0}}) {
            const auto other = hit(x + dx, y + dy);
            if (!other || std::abs((*other - eye()).norm() / across.norm() - 1) > 0.02) return {};
        }
        return middle;
    }

  private:
    Eigen::Vector3d eye() const { return view_.cam_from_origin.center() + origin_; }
    std::optional<Eigen::Vector3d> hit(double x, double y) const {
        const Intrinsics& k = view_.intrinsics;
        const Eigen::Vector3d ray =
            view_.cam_from_origin.R.transpose() * Eigen::Vector3d((x - k.cx) / k.fx, (y - k.cy) / k.fy, 1);
        const auto found = scene_.first_hit(eye(), ray);
        if (!found) return {};
        return eye() + found->distance * ray;
    }
    RayScene scene_;
    Eigen::Vector3d origin_;
    const View& view_;
};

int difference(const Picture& p, std::size_t pixel, const std::array<std::uint8_t, 4>& code) {
    int most = 0;
    for (std::size_t c = 0; c < 3; ++c)
        most = std::max(most, std::abs(int(p.rgba[4 * pixel + c]) - int(code[c])));
    return most;
}

std::array<std::uint8_t, 4> field_code_at(const Picture& p, std::size_t pixel) {
    return {p.rgba[4 * pixel], p.rgba[4 * pixel + 1], p.rgba[4 * pixel + 2], p.rgba[4 * pixel + 3]};
}

}  // namespace

TEST_F(ScalarFields, ColorsAreThoseOfTheValuesThatRaysMeet) {
    add("height", height);
    const PackageReader package = prepared();
    const gl::HeadlessContext context;
    Renderer renderer(package, MemoryBudget{});
    const View view = view_of_photo(package.photos()[0], 0.5);
    RenderSettings settings;
    settings.field.index = 0;
    const Eigen::Vector3d origin = Eigen::Map<const Eigen::Vector3d>(package.scene().origin);
    const Rays rays(scene.mesh, origin, view);
    const ScalarField& field = renderer.resources().fields.all()[0];
    EXPECT_EQ(field.name, "height");
    for (const ColorMap map : {ColorMap::viridis, ColorMap::coolwarm})
        for (const bool clamped : {false, true}) {
            settings.field.map = map;
            settings.field.range.reset();
            const bool diverges = map == ColorMap::coolwarm;
            if (clamped) settings.field.range = ValueRange{diverges ? -0.5 : 1, 2};
            const Picture picture = take_picture(renderer, view, settings, all(package), 1);
            const auto [shown, range, center] = field_legend(field, settings.field);
            const ColorTable table = color_table(shown);
            std::size_t compared = 0, wrong = 0;
            for (int y = 0; y < picture.height; ++y)
                for (int x = 0; x < picture.width; ++x) {
                    const auto at = rays.surface(x + 0.5, y + 0.5);
                    if (!at) continue;
                    const double h = std::clamp(height(*at), range.low, range.high),
                                 t = diverges && clamped ? 0.5 + h / 4  // 0 keeps the light center
                                                         : (h - range.low) / (range.high - range.low);
                    const auto code = table[std::size_t(std::lround(255 * t))];
                    const auto pixel = std::size_t(y) * std::size_t(picture.width) + std::size_t(x);
                    ++compared;
                    wrong += difference(picture, pixel, code) > 4;
                }
            EXPECT_GT(compared, 2000u);
            EXPECT_LT(double(wrong), 0.002 * double(compared)) << name_of(map) << (clamped ? " clamped" : "");
        }
}

TEST_F(ScalarFields, PhotosAreShownWhereAFieldHasNoValueAndMixedWhereAsked) {
    add("left", [](const Eigen::Vector3d& p) { return p.x() < 0 ? p.z() : double(none); });
    const PackageReader package = prepared();
    const gl::HeadlessContext context;
    Renderer renderer(package, MemoryBudget{});
    const View view = view_of_photo(package.photos()[0], 0.5);
    RenderSettings settings;
    const Picture photos = take_picture(renderer, view, settings, all(package), 1);
    settings.field.index = 0;
    const Picture field = take_picture(renderer, view, settings, all(package), 1);
    settings.field.share = 0.5;
    const Picture half = take_picture(renderer, view, settings, all(package), 1);
    settings.field.share = 0;
    EXPECT_EQ(take_picture(renderer, view, settings, all(package), 1).rgba, photos.rgba);
    const Eigen::Vector3d origin = Eigen::Map<const Eigen::Vector3d>(package.scene().origin);
    const Rays rays(scene.mesh, origin, view);
    std::size_t left = 0, right = 0, shown = 0;
    for (std::size_t i = 0; i < photos.rgba.size() / 4; ++i) {
        const auto at = rays.surface(double(i % std::size_t(photos.width)) + 0.5,
                                     double(i / std::size_t(photos.width)) + 0.5);
        if (!at) continue;
        if (at->x() >= 0) {
            ++right;
            EXPECT_EQ(field_code_at(field, i), field_code_at(photos, i)) << at->transpose();
            continue;
        }
        ++left;
        const auto mixed = field_code_at(half, i), a = field_code_at(photos, i), b = field_code_at(field, i);
        shown += difference(field, i, a) > 0;
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_GE(mixed[c] + 1, std::min(a[c], b[c]));
            EXPECT_LE(mixed[c], std::max(a[c], b[c]) + 1);
        }
    }
    EXPECT_GT(right, 500u);
    // Triangles that cross the border have no value either.
    EXPECT_GT(double(shown), 0.5 * double(left));
}

TEST_F(ScalarFields, LogarithmsAndLinesAreWhereTheyBelong) {
    add("distance", [](const Eigen::Vector3d& p) { return std::exp(height(p) / 3); });
    const PackageReader package = prepared();
    const gl::HeadlessContext context;
    Renderer renderer(package, MemoryBudget{});
    const View view = view_of_photo(package.photos()[0], 0.5);
    RenderSettings settings;
    settings.field.index = 0, settings.field.logarithmic = true;
    settings.field.range = ValueRange{std::exp(-0.5), std::exp(2.0)};
    const Picture plain = take_picture(renderer, view, settings, all(package), 1);
    settings.field.isolines = 5;  // where the exponent is a multiple of 0.5
    const Picture lines = take_picture(renderer, view, settings, all(package), 1);
    const Eigen::Vector3d origin = Eigen::Map<const Eigen::Vector3d>(package.scene().origin);
    const Rays rays(scene.mesh, origin, view);
    std::size_t far = 0, far_changed = 0, changed = 0;
    for (std::size_t i = 0; i < plain.rgba.size() / 4; ++i) {
        const double x = double(i % std::size_t(plain.width)) + 0.5,
                     y = double(i / std::size_t(plain.width)) + 0.5;
        const auto at = rays.surface(x, y);
        if (!at) continue;
        const bool differs = field_code_at(plain, i) != field_code_at(lines, i);
        changed += differs;
        const double turns = height(*at) / 3 / 0.5, away = std::abs(turns - std::round(turns));
        if (away < 0.25) continue;
        ++far;
        far_changed += differs;
    }
    EXPECT_GT(changed, 100u);
    EXPECT_GT(far, 1000u);
    // The exponential function is not linear between vertices, so lines on large triangles are displaced.
    EXPECT_LT(double(far_changed), 0.02 * double(far));
}

TEST_F(ScalarFields, ValuesUnderThePointerAreThoseOfTheSurface) {
    add("height", height);
    const PackageReader package = prepared();
    const gl::HeadlessContext context;
    Renderer renderer(package, MemoryBudget{});
    const View view = view_of_photo(package.photos()[0], 0.5);
    take_picture(renderer, view, {}, all(package), 1);
    const std::vector<std::uint32_t> triangles = read_triangles(renderer.resources().targets);
    const Eigen::Vector3d origin = Eigen::Map<const Eigen::Vector3d>(package.scene().origin);
    const Rays rays(scene.mesh, origin, view);
    const std::span<const float> values = renderer.resources().fields.all()[0].values;
    std::size_t compared = 0;
    for (int y = 3; y < view.intrinsics.height; y += 7)
        for (int x = 3; x < view.intrinsics.width; x += 7) {
            const Eigen::Vector2d pixel(x + 0.5, y + 0.5);
            const std::uint32_t triangle =
                triangles[std::size_t(y) * std::size_t(view.intrinsics.width) + std::size_t(x)];
            const auto value = value_at_pixel(renderer.scene(), values, triangle - 1, view, pixel);
            EXPECT_TRUE(triangle > 0 || !value);
            const auto at = rays.surface(pixel.x(), pixel.y());
            if (!at || !value) continue;
            EXPECT_NEAR(*value, height(*at), 2e-3);
            ++compared;
        }
    EXPECT_GT(compared, 50u);
}

TEST_F(ScalarFields, NothingOfThemIsThereWhenTheyAreOff) {
    const PackageReader without = prepared();
    EXPECT_FALSE(effect_on(without.scene(), Effect::scalar_fields));
    const gl::HeadlessContext context;
    const auto shown = [&](const PackageReader& package, int field = -1) {
        Renderer renderer(package, MemoryBudget{.graphics = std::uint64_t(200) << 20});
        RenderSettings settings;
        settings.field.index = field;
        const View view = view_of_photo(package.photos()[0], 0.5);
        const Picture picture = take_picture(renderer, view, settings, all(package), 1);
        return std::pair(picture.rgba, gl::memory_held());
    };
    const auto bare = shown(without);
    add("constant", [](const Eigen::Vector3d&) { return 4.0; });
    add("unknown", [](const Eigen::Vector3d&) { return double(none); });
    {
        const PackageReader constant = prepared();
        EXPECT_FALSE(effect_on(constant.scene(), Effect::scalar_fields)) << "nothing varies";
        EXPECT_FALSE(constant.find(package::Type::scalars, package::scene_wide));
    }
    add("height", height);
    {
        const PackageReader off = prepared(EffectChoice::off);
        EXPECT_FALSE(off.find(package::Type::scalars, package::scene_wide));
        EXPECT_TRUE(read_fields(off).empty());
        EXPECT_EQ(shown(off), bare);
    }
    const PackageReader on = prepared();
    EXPECT_TRUE(effect_on(on.scene(), Effect::scalar_fields));
    EXPECT_TRUE(misshapen(on).empty());
    ASSERT_EQ(read_fields(on).size(), 3u);
    EXPECT_EQ(shown(on), bare) << "a field should cost nothing before it is shown";
    EXPECT_GT(shown(on, 0).second, bare.second);
}

TEST_F(ScalarFields, PhotosAreCountedAndTheirDensityMeasuredAsByRays) {
    const PackageReader package = prepared();
    const std::vector<float> count = measure_photos(package, PhotoMeasure::count),
                             density = measure_photos(package, PhotoMeasure::density);
    const auto positions = package.records<Eigen::Vector3f>(package::Type::positions);
    ASSERT_EQ(count.size(), positions.size());
    ASSERT_EQ(density.size(), positions.size());
    const Eigen::Vector3d origin = Eigen::Map<const Eigen::Vector3d>(package.scene().origin);
    const RayScene rays(scene.mesh);
    std::size_t seen = 0, same = 0, dense = 0;
    for (std::size_t v = 0; v < positions.size(); ++v) {
        const Eigen::Vector3d at = positions[v].cast<double>();
        int photos = 0;
        double most = 0;
        for (const package::PhotoRecord& photo : package.photos()) {
            const Pose pose = cam_from_origin(photo);
            const auto p = project(intrinsics(photo), pose, at);
            if (!p || p->pixel.x() < 0 || p->pixel.y() < 0 || p->pixel.x() > photo.width ||
                p->pixel.y() > photo.height)
                continue;
            const Eigen::Vector3d ray = at - pose.center();
            const auto hit = rays.first_hit(origin + pose.center(), ray);
            if (hit && hit->distance < 0.999) continue;
            ++photos;
            most = std::max(most, photo.fx / (pose.R * at + pose.t).z());
        }
        EXPECT_EQ(count[v] > 0, density[v] > 0) << "both should be NaN where no photo sees the vertex";
        EXPECT_LE(count[v], photos + 1) << "at an edge, one more photo than rays find is allowed";
        seen += photos > 0;
        same += photos > 0 && count[v] == float(photos);
        dense += photos > 0 && std::abs(density[v] - most) < 1e-3 * most;
    }
    // Next to the photo's edge or an occluder's edge, triangles are not entirely visible.
    EXPECT_GT(seen, positions.size() / 2);
    EXPECT_GT(double(same), 0.9 * double(seen));
    EXPECT_GT(double(dense), 0.9 * double(seen));
}

TEST_F(ScalarFields, WhatPhotosSeeIsAFieldOfEveryPackageAndCostsNothingUntilShown) {
    const PackageReader package = prepared();
    ASSERT_TRUE(read_fields(package).empty());
    const gl::HeadlessContext context;
    Renderer renderer(package, MemoryBudget{.graphics = std::uint64_t(200) << 20});
    ASSERT_EQ(renderer.resources().fields.all().size(), 2u);
    EXPECT_EQ(renderer.resources().fields.all()[0].name, "photo-count");
    EXPECT_TRUE(renderer.resources().fields.all()[0].values.empty());
    const View view = view_of_photo(package.photos()[0], 0.5);
    RenderSettings settings;
    const Picture photos = take_picture(renderer, view, settings, all(package), 1);
    settings.field.index = field_named(renderer.resources().fields.all(), "photo-count");
    const Picture counted = take_picture(renderer, view, settings, all(package), 1);
    const ScalarField& field = renderer.resources().fields.all()[0];
    EXPECT_GE(field.low, 0);
    EXPECT_LE(field.high, double(package.photos().size()));
    EXPECT_EQ(field.high, *std::ranges::max_element(field.values));
    EXPECT_NE(counted.rgba, photos.rgba);
    settings.field.index = 1;
    EXPECT_NE(take_picture(renderer, view, settings, all(package), 1).rgba, counted.rgba);
    settings.field.index = 0;
    EXPECT_EQ(take_picture(renderer, view, settings, all(package), 1).rgba, counted.rgba);
    settings.field.index = -1;
    EXPECT_EQ(take_picture(renderer, view, settings, all(package), 1).rgba, photos.rgba);
    add("photo-count", height);
    const PackageReader own = prepared();
    const std::vector<ScalarField> fields = all_fields(own);
    ASSERT_EQ(fields.size(), 2u);
    EXPECT_EQ(fields[0].name, "photo-count");
    EXPECT_FALSE(fields[0].measure) << "the field from the file should come first";
}
