// Tests transparent surfaces in pictures: with nothing behind them, in front of photos, points and holes, and
// with lighting.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>

#include "base/gl/context.h"
#include "base/values/srgb.h"
#include "pipeline/formats/meshes/read_mesh.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/prepare/prepare.h"
#include "pipeline/reports/check.h"
#include "pipeline/synth/synthesize.h"
#include "player/render/picture.h"
#include "scene/package/contents/opaque_part.h"
#include "shaders/contract.h"
#include "tests/bench/painter/transparent_layers.h"
#include "tests/made_scenes.h"
#include "tests/programs/pictures/transparency/transparent_scene.h"

using namespace vantage;

namespace {

using Eigen::Vector3d;
using Eigen::Vector4d;

class TransparentAtLength : public Transparent {};

}  // namespace

TEST_F(Transparent, AWhollyTransparentMeshIsShownWithNothingBehind) {
    input.mesh = {};
    const std::array<std::uint8_t, 4> own{200, 100, 50, 128};
    add_quad({-2, 0, 0}, {4, 0, 0}, {0, 0, 4}, own);
    add_quad({-2, -1, 0}, {2, 0, 0}, {0, 0, 4}, {255, 255, 255, 0});
    const PackageReader package = prepared();
    EXPECT_TRUE(check_package(package.path(), {.deep = true}).empty());
    for (std::uint32_t i = 0; i < package.photos().size(); ++i) {
        EXPECT_EQ(package.photos()[i].visible_vertices, 0);
        for (const std::uint64_t bits : package.records<std::uint64_t>(package::Type::visible, i))
            EXPECT_EQ(bits, 0u);
    }
    const gl::HeadlessContext context;
    Renderer renderer(package, MemoryBudget{});
    const View view = facing(package);
    for (const Transparency mode : {Transparency::exact, Transparency::approximate})
        for (const int side : {1, 2}) {
            const Picture p = taken(renderer, view, shown_as(mode), side);
            const std::size_t middle = 4 * (std::size_t(p.width) * std::size_t(p.height) / 2 + 80);
            EXPECT_NEAR(p.rgba[middle + 3], 128, 1)
                << "the quad should have its own alpha, and the quad with alpha 0 should be invisible";
            for (std::size_t c = 0; c < 3; ++c)
                EXPECT_NEAR(p.rgba[middle + c], own[c], 1)
                    << "the color should not be premultiplied, nor shaded, as the surface faces the viewer";
            EXPECT_EQ(p.rgba[3], 0) << "empty";
        }
    const Picture off = taken(renderer, view, shown_as(Transparency::off));
    EXPECT_TRUE(std::ranges::all_of(off.rgba, [](std::uint8_t c) { return c == 0; }));
    RenderSettings filled = shown_as(Transparency::exact);
    filled.fill_holes = true;
    const Picture over = taken(renderer, view, filled);
    for (std::size_t i = 3; i < over.rgba.size(); i += 4) ASSERT_EQ(over.rgba[i], 255) << "a background";
}

TEST_F(TransparentAtLength, IsLitColoredAndCoveredAsTheModelIs) {
    ground();
    add_quad({-2, -1, 1}, {4, 0, 0}, {0, 0, 2}, {200, 100, 50, 128});
    VertexField field{"height", {}};
    for (const Vector3d& p : input.mesh.positions)
        field.values.push_back(p.y() == -1 && p.z() > 0 ? 1.0f : 0.0f);
    input.mesh.scalars.push_back(field);
    // The points are in front of the quad on the left and behind it on the right.
    for (int x = -200; x <= 200; ++x)
        for (int z = 0; z < 200; ++z) {
            input.points.positions.emplace_back(0.01 * x, x < 0 ? -2.0 : -0.5, 1 + 0.01 * z);
            input.points.colors.push_back({20, 20, 220, 255});
        }
    input.files.points = {dir / "cloud.ply"};
    std::ofstream(dir / "cloud.ply") << "cloud";
    const PackageReader package = prepared();
    const gl::HeadlessContext context;
    Renderer renderer(package, MemoryBudget{});
    const View view = facing(package);
    const std::size_t left = 60 * 160 + 70, right = 60 * 160 + 90;
    const auto at = [&](const RenderSettings& s, std::size_t pixel) {
        return light(renderer, view, s)[pixel];
    };
    const auto with = [&](auto change) {
        RenderSettings on, off;
        on.points.show = off.points.show = false;
        on.fill_holes = off.fill_holes = true;
        off.transparency = Transparency::off;
        change(on), change(off);
        return std::pair(on, off);
    };
    const auto& decoded = linear_of_srgb_byte();
    const Vector3d own(decoded[200], decoded[100], decoded[50]);
    const double alpha = 128 / 255.0;
    const auto expect_over = [&](const std::pair<RenderSettings, RenderSettings>& s, std::size_t pixel,
                                 const Vector3d& color, const char* what) {
        const Vector4d behind = at(s.second, pixel), shown = at(s.first, pixel);
        const Vector3d expected = alpha * color + (1 - alpha) * behind.head<3>();
        EXPECT_LT((shown.head<3>() - expected).norm(), 0.01) << what << ": " << shown.transpose();
    };
    expect_over(with([](RenderSettings&) {}), left, own, "over photos");
    expect_over(with([](RenderSettings& s) { s.light.light = Light::lamp; }), left,
                Vector3d::Constant(shader::light_gray), "bare geometry that faces the lamp");
    expect_over(with([](RenderSettings& s) { s.light.light = Light::lamp, s.light.on_photos = true; }), left,
                own, "the quad's own color multiplied by the light");
    const auto shows_points = with([](RenderSettings& s) { s.points.show = true, s.points.eye_dome = 0; });
    EXPECT_EQ(at(shows_points.first, left), at(shows_points.second, left))
        << "the points should be in front of the quad";
    expect_over(shows_points, right, own, "points behind it");
    const auto alone = with([](RenderSettings& s) { s.points.alone = s.points.show = true; });
    EXPECT_EQ(at(alone.first, right), at(alone.second, right)) << "points alone";
    const auto layered = with([](RenderSettings& s) { s.field.index = 0; });
    const Vector4d shown = at(layered.first, left), behind = at(layered.second, left);
    EXPECT_GT((shown - behind).norm(), 0.2) << "the color map's end should be blended over its beginning";
    const auto counted = with([](RenderSettings& s) { s.show = Show::coverage; });
    EXPECT_EQ(at(counted.first, left), at(counted.second, left)) << "counts should not be blended";
}

TEST_F(Transparent, HolesBehindItAreFilledWithColorsWithoutIt) {
    SynthSpec spec = tiny_spec();
    spec.garden.radius = 30;
    copy_scene(spec, dir / "garden");
    input = read_scene(discover(dir / "garden"));
    add_quad({-6, -5, 0}, {12, 0, 0}, {0, 0, 9}, {200, 100, 50, 128});
    settings.effects[Effect::background] = EffectChoice::on;
    const PackageReader package = prepared();
    ASSERT_TRUE(effect_on(package.scene(), Effect::background));
    const gl::HeadlessContext context;
    Renderer renderer(package, MemoryBudget{});
    const Vector3d origin = Eigen::Map<const Vector3d>(package.scene().origin);
    const View view =
        view_towards(Vector3d(-7, -12, 3) - origin, Vector3d(2, 0, 3) - origin, {0, 0, 1}, 60, 160, 120);
    const auto pixels = TransparentLayers(package).fragments(view);
    RenderSettings on = shown_as(Transparency::exact), off = shown_as(Transparency::off);
    const auto holes = light(renderer, view, off);
    const Picture behind = shown_picture(renderer, view, off);
    for (const int side : {1, 2}) {
        const Picture shown = taken(renderer, view, on, side),
                      without = side == 1 ? behind : taken(renderer, view, off, side);
        std::size_t filled = 0, right = 0;
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            if (pixels[i].fragments.size() != 1 || pixels[i].edge || holes[i][3] > 0.5) continue;
            ++filled;
            const auto& f = pixels[i].fragments[0];
            const double covers =
                without.rgba[4 * i + 3] / 255.0;  // beyond the background, nothing is covered
            int most = 0;
            for (std::size_t c = 0; c < 3; ++c) {
                const double s = without.rgba[4 * i + c] / 255.0,
                             linear = s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
                const double own = f.alpha * f.color[Eigen::Index(c)],
                             alpha = f.alpha + (1 - f.alpha) * covers,
                             expected = encoded((own + (1 - f.alpha) * covers * linear) / alpha);
                most =
                    std::max(most, std::abs(int(std::lround(255 * expected)) - int(shown.rgba[4 * i + c])));
            }
            right += most <= 2;
        }
        EXPECT_GT(filled, 300u);
        EXPECT_GE(double(right), 0.99 * double(filled)) << side;
    }
}

TEST_F(TransparentAtLength, PhotosLookThroughAGlassCase) {
    const std::string folder = dir.string(), glass = folder + "/glass", package = glass + ".vantage";
    const auto runs = [&](const std::string& command) {
        EXPECT_EQ(std::system((command + " >" + folder + "/says 2>&1").c_str()), 0) << command << "\n"
                                                                                    << slurp(dir / "says");
        return slurp(dir / "says");
    };
    const std::string vantage = VANTAGE_PROGRAM, player = VANTAGE_PLAYER;
    runs(vantage + " synth " VANTAGE_SOURCE_DIR "/data/glass.toml -o " + glass);
    runs(vantage + " prepare " + glass + " -o " + package + " --vertex-coordinates");
    runs(vantage + " check --deep --against " + glass + " " + package);
    EXPECT_NE(runs(vantage + " info " + package).find("transparency       on"), std::string::npos);
    // The photos have the same visibility data as in the scene without the glass case.
    SynthSpec spec = spec_named("glass");
    spec.glass.alpha = 0;
    copy_scene(spec, dir / "bare");
    runs(vantage + " prepare " + folder + "/bare -o " + folder + "/bare.vantage");
    const PackageReader with(package), without(dir / "bare.vantage");
    const OpaquePart opaque = opaque_part(with);
    EXPECT_EQ(opaque.clusters, without.scene().clusters);
    for (std::uint32_t i = 0; i < with.photos().size(); ++i) {
        EXPECT_EQ(with.find(package::Type::depth, i, 1)->checksum,
                  without.find(package::Type::depth, i, 1)->checksum);
        const auto seen = with.records<package::CoverageRecord>(package::Type::coverage, i),
                   of_bare = without.records<package::CoverageRecord>(package::Type::coverage, i);
        for (std::size_t c = 0; c < seen.size(); ++c)
            EXPECT_EQ(seen[c].seen, c < of_bare.size() ? of_bare[c].seen : 0);
        const auto uv = with.records<std::array<float, 2>>(package::Type::coordinates, i);
        for (std::size_t v = opaque.vertices; v < uv.size(); ++v) EXPECT_EQ(uv[v][0], -1);
    }
    // The glass tints the surfaces behind it but hides none of them.
    const auto picture = [&](const std::string& file, const std::string& options) {
        runs(player + " render " + file + " --photo 0002 -o " + folder + "/p.png " + options);
        return read_png(dir / "p.png");
    };
    const Picture exact = picture(package, ""), approximate = picture(package, "--transparency approximate"),
                  off = picture(package, "--transparency off"), bare = picture(folder + "/bare.vantage", "");
    std::size_t tinted = 0, gone = 0, bright = 0, apart = 0, differs = 0;
    for (std::size_t i = 0; i < bare.rgba.size(); i += 4) {
        const auto change = [&](const Picture& p, const Picture& from) {
            int most = 0;
            for (std::size_t c = 0; c < 3; ++c)
                most = std::max(most, std::abs(int(p.rgba[i + c]) - int(from.rgba[i + c])));
            return most;
        };
        gone += change(off, bare) > 1;
        if (change(exact, off) <= 2) continue;
        ++tinted;
        // Of the light from behind, (1 - 0.3)^1 or (1 - 0.3)^2 remains, and the glass adds its own color.
        bright += exact.rgba[i + 1] + 2 >= int(255 * encoded(0.4 * std::pow(off.rgba[i + 1] / 255.0, 2.2)));
        apart += change(approximate, exact) > 40;
        differs += change(approximate, exact) > 0;
    }
    EXPECT_EQ(gone, 0u) << "with transparency off, the picture should be that of the scene without the case";
    EXPECT_GT(tinted, 331u * 250 / 20);
    EXPECT_GE(double(bright), 0.99 * double(tinted));
    EXPECT_LT(double(apart), 0.05 * double(tinted));
    EXPECT_GT(differs, 0u);
    // The extracted mesh has the glass's alpha.
    runs(vantage + " extract " + package + " -o " + folder + "/files");
    std::vector<std::string> warnings;
    const Mesh back = read_mesh(dir / "files" / "mesh.ply", warnings);
    ASSERT_EQ(back.colors.size(), with.scene().vertices);
    for (std::size_t v = 0; v < back.colors.size(); ++v)
        EXPECT_EQ(int(back.colors[v][3]), v < opaque.vertices ? 255 : 77);
}
