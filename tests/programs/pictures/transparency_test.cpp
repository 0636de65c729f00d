// Transparent surfaces, compared with rays through pixels that are blended in double precision.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <numeric>
#include <random>

#include "base/gl/context.h"
#include "pipeline/formats/meshes/read_mesh.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/mesh/ray_scene.h"
#include "pipeline/prepare/merge_packages.h"
#include "pipeline/prepare/prepare.h"
#include "pipeline/prepare/refine_package.h"
#include "pipeline/reports/check.h"
#include "pipeline/run/until_stopped.h"
#include "pipeline/synth/synthesize.h"
#include "player/render/picture.h"
#include "scene/package/contents/opaque_part.h"
#include "shaders/contract.h"
#include "tests/bench/painter/bsp_tree.h"
#include "tests/bench/painter/transparent_layers.h"
#include "tests/fuzz/support/valid_package.h"
#include "tests/made_scenes.h"
#include "tests/temporary_folder.h"

using namespace vantage;

namespace {

using Eigen::Vector3d;
using Eigen::Vector4d;
using Color = std::array<std::uint8_t, 4>;

double encoded(double l) {
    l = std::clamp(l, 0.0, 1.0);
    return l <= 0.0031308 ? 12.92 * l : 1.055 * std::pow(l, 1 / 2.4) - 0.055;
}

/// The largest difference of channels, in codes of 8 bits. The second may be empty pixels' color.
double codes_apart(const Vector4d& a, const Vector4d& b) {
    double most = 255 * std::abs(a[3] - b[3]);
    for (int c = 0; c < 3; ++c) most = std::max(most, 255 * std::abs(encoded(a[c]) - encoded(b[c])));
    return most;
}

class Transparent : public TemporaryFolder {
  protected:
    void SetUp() override {
        TemporaryFolder::SetUp();
        SynthSpec spec = tiny_spec();
        copy_scene(spec, dir / "scene");
        input = read_scene(discover(dir / "scene"));
        settings.validate = false;
        settings.effects[Effect::background] = EffectChoice::off;
    }
    /// A triangle of its own, with one normal.
    void add(const std::array<Vector3d, 3>& corners, const std::array<Color, 3>& colors) {
        Mesh& m = input.mesh;
        const Vector3d n = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
        m.colors.resize(m.positions.size(), {255, 255, 255, 255});
        const auto first = std::uint32_t(m.positions.size());
        for (std::size_t i = 0; i < 3; ++i) {
            m.positions.push_back(corners[i]);
            m.normals.push_back(n.cast<float>());
            m.colors.push_back(colors[i]);
        }
        m.triangles.push_back({first, first + 1, first + 2});
    }
    void add_quad(const Vector3d& corner, const Vector3d& u, const Vector3d& v, const Color& color) {
        add({corner, corner + u, corner + u + v}, {color, color, color});
        add({corner, corner + u + v, corner + v}, {color, color, color});
    }
    /// Ground so wide that nothing on it is subdivided, and a wall on it.
    void ground() {
        input.mesh = {};
        for (int x = 0; x < 70; ++x)
            for (int y = 0; y < 70; ++y)
                add_quad({-250 + x * 500 / 70.0, -250 + y * 500 / 70.0, 0}, {500 / 70.0, 0, 0},
                         {0, 500 / 70.0, 0}, {255, 255, 255, 255});
        add_quad({-1.5, 0.5, 0}, {2.5, 0, 0}, {0, 0, 2.5}, {255, 255, 255, 255});
    }
    Color random_color() {
        std::uniform_int_distribution<int> code(0, 255);
        return {std::uint8_t(code(random)), std::uint8_t(code(random)), std::uint8_t(code(random)), 255};
    }
    /// Triangles that cross each other, with alpha from 0 to 1, both included; every fifth lies in the plane
    /// of the one before it, at the same place or at another. These planes face the viewer, or are
    /// `inclined`.
    void scatter(int count, int max_alpha, bool inclined) {
        std::uniform_real_distribution<double> across(-3, 3), up(0.2, 4.5), size(1, 4);
        std::uniform_int_distribution<int> alpha(0, max_alpha), kind(0, 9);
        std::array<Vector3d, 3> before;
        before.fill(Vector3d::Zero());
        for (int i = 0; i < count; ++i) {
            const Vector3d middle(across(random), across(random), up(random));
            std::array<Vector3d, 3> corners;
            for (Vector3d& c : corners)
                c = middle + size(random) * Vector3d(across(random), across(random), across(random)) / 3;
            if (i % 5 == 3 && !inclined)
                for (Vector3d& c : corners) c.y() = middle.y();
            if (i % 5 == 4)
                for (std::size_t j = 0; j < 3; ++j)
                    corners[j] = i % 10 == 4 ? before[j] : 0.7 * before[j] + 0.3 * before[(j + 1) % 3];
            before = corners;
            std::array<Color, 3> colors;
            for (Color& c : colors) {
                c = random_color();
                const int k = kind(random);
                c[3] = std::uint8_t(k == 0 ? 0 : k == 1 ? 255 : alpha(random));
            }
            if (colors[0][3] == 255 && colors[1][3] == 255) colors[0][3] = 100;
            add(corners, colors);
        }
    }
    PackageReader prepared(const std::string& name = "scene", const PrepareRun& run = {}) const {
        prepare(
            input, settings, dir / (name + ".vantage"), [](const Progress&) {}, run);
        return PackageReader(dir / (name + ".vantage"));
    }
    static std::vector<std::uint32_t> all(const PackageReader& package) {
        std::vector<std::uint32_t> photos(package.photos().size());
        std::iota(photos.begin(), photos.end(), 0u);
        return photos;
    }
    static RenderSettings shown_as(Transparency mode) {
        RenderSettings s;
        s.transparency = mode;
        return s;
    }
    static Picture taken(Renderer& renderer, const View& view, const RenderSettings& settings, int side = 1) {
        return take_picture(renderer, view, settings, all(renderer.package()), side);
    }
    /// The samples of a picture: linear light and coverage.
    static std::vector<Vector4d> light(Renderer& renderer, const View& view, const RenderSettings& settings) {
        taken(renderer, view, settings);
        std::vector<Eigen::Vector4f> out(std::size_t(view.intrinsics.width) *
                                         std::size_t(view.intrinsics.height));
        glGetTextureImage(renderer.targets().samples.front().sum.id(), 0, GL_RGBA, GL_FLOAT,
                          GLsizei(out.size() * 16), out.data());
        std::vector<Vector4d> light;
        for (const Eigen::Vector4f& l : out) light.push_back(l.cast<double>());
        return light;
    }
    static View facing(const PackageReader& package, double fov = 30, int width = 160, int height = 120) {
        const Vector3d origin = Eigen::Map<const Vector3d>(package.scene().origin);
        return view_towards(Vector3d(0, -14, 2.5) - origin, Vector3d(0, 0, 2.5) - origin, {0, 0, 1}, fov,
                            width, height);
    }
    /// Depth of the opaque surface at each pixel.
    std::vector<double> opaque_depth(const PackageReader& package, const View& view) const {
        Mesh opaque = input.mesh;
        std::erase_if(opaque.triangles, [&](const auto& t) {
            return opaque.colors[t[0]][3] < 255 || opaque.colors[t[1]][3] < 255 ||
                   opaque.colors[t[2]][3] < 255;
        });
        std::vector<double> out;
        const Intrinsics& k = view.intrinsics;
        if (opaque.triangles.empty()) return std::vector<double>(std::size_t(k.width * k.height), 1e300);
        const RayScene rays(opaque);
        const Vector3d origin = Eigen::Map<const Vector3d>(package.scene().origin);
        const Eigen::Matrix3d turned = view.cam_from_origin.R.transpose();
        for (int y = 0; y < k.height; ++y)
            for (int x = 0; x < k.width; ++x) {
                const Vector3d ray((x + 0.5 - k.cx) / k.fx, (y + 0.5 - k.cy) / k.fy, 1);
                const auto hit = rays.first_hit(view.cam_from_origin.center() + origin, turned * ray);
                out.push_back(hit ? hit->distance : 1e300);
            }
        return out;
    }
    SceneInput input;
    PrepareSettings settings;
    std::mt19937 random{7};
};
class TransparentAtLength : public Transparent {};

/// Distance by which fragments of triangles in one plane differ at most, by the rounding of their corners.
constexpr double one_plane = 3e-6;

/// Whether the order of fragments depends on rounding: planes that cross at the pixel, or the opaque surface.
bool crosses(std::vector<TransparentLayers::Fragment> fragments, double opaque) {
    std::ranges::sort(fragments, {}, &TransparentLayers::Fragment::z);
    for (std::size_t i = 0; i < fragments.size(); ++i) {
        if (std::abs(fragments[i].z - opaque) < 1e-3) return true;
        const double apart = i > 0 ? fragments[i].z - fragments[i - 1].z : 1;
        if (apart > one_plane && apart < 1e-4) return true;
    }
    return false;
}

/// Planes at one place have one distance, and their order is that of the triangles.
void tie(std::vector<TransparentLayers::Fragment>& fragments) {
    std::ranges::sort(fragments, {}, &TransparentLayers::Fragment::z);
    for (std::size_t i = 1; i < fragments.size(); ++i)
        if (fragments[i].z - fragments[i - 1].z <= one_plane) fragments[i].z = fragments[i - 1].z;
}

}  // namespace

TEST_F(Transparent, ExactBlendingIsThatOfSortedFragments) {
    for (const auto& [max_alpha, inclined] :
         {std::pair(255, false), std::pair(40, false), std::pair(255, true)}) {
        ground();
        scatter(560, max_alpha, inclined);
        const PackageReader package =
            prepared(std::string(inclined ? "inclined" : "facing") + std::to_string(max_alpha));
        ASSERT_TRUE(effect_on(package.scene(), Effect::transparency));
        const gl::HeadlessContext context;
        Renderer renderer(package, MemoryBudget{});
        // Lists have room for 4 layers on average, so that 64 may cover a part of the frame.
        const View view = facing(package, 75, 200, 200);
        const FrameReport report = taken(renderer, view, shown_as(Transparency::exact)).report;
        ASSERT_EQ(report.fragments_approximated, 0u) << "of " << report.fragments;
        const auto exact = light(renderer, view, shown_as(Transparency::exact));
        const auto approximate = light(renderer, view, shown_as(Transparency::approximate));
        const auto behind = light(renderer, view, shown_as(Transparency::off));
        auto pixels = TransparentLayers(package).fragments(view);
        const std::vector<double> opaque = opaque_depth(package, view);
        std::size_t most = 0, compared = 0, tied = 0, hidden = 0;
        double worst = 0, approximation = 0, worst_approximation = 0;
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            auto& f = pixels[i].fragments;
            if (f.empty() || pixels[i].edge || crosses(f, opaque[i])) continue;
            hidden += std::erase_if(f, [&](const auto& one) { return one.z > opaque[i]; });
            most = std::max(most, f.size());
            if (f.size() > std::size_t(shader::max_sorted_fragments)) continue;
            tie(f);
            for (std::size_t j = 1; j < f.size(); ++j) tied += f[j].z == f[j - 1].z;
            const Vector4d expected = blended(f, behind[i]);
            ++compared;
            worst = std::max(worst, codes_apart(exact[i], expected));
            const double off = codes_apart(approximate[i], expected);
            approximation += off, worst_approximation = std::max(worst_approximation, off);
        }
        EXPECT_GT(compared, 1500u);
        EXPECT_GT(most, 44u);
        EXPECT_LE(most, 64u);
        EXPECT_GT(tied, 1000u) << "coplanar triangles";
        EXPECT_GT(hidden, 1000u) << "behind the wall";
        EXPECT_LE(worst, 1.0) << "codes of 8 bits";
        approximation /= double(compared);
        std::printf("%s, alpha up to %d: exact within %.3f codes; approximate: mean %.1f, worst %.1f codes\n",
                    inclined ? "inclined" : "facing", max_alpha, worst, approximation, worst_approximation);
        EXPECT_GT(approximation, 0.5) << "the approximation is told from what it approximates";
        EXPECT_LT(approximation, 45);
    }
}

TEST_F(Transparent, ExactBlendingIsThatOfThePaintersAlgorithm) {
    ground();
    scatter(24, 255, false);
    const PackageReader package = prepared();
    const gl::HeadlessContext context;
    Renderer renderer(package, MemoryBudget{});
    const View view = facing(package);
    const auto exact = light(renderer, view, shown_as(Transparency::exact));
    auto painted = light(renderer, view, shown_as(Transparency::off));
    const TransparentLayers layers(package);
    const auto pixels = layers.fragments(view);
    const std::vector<double> opaque = opaque_depth(package, view);
    const auto triangles = layers.triangles();
    const BspTree tree(triangles);
    ASSERT_TRUE(tree.complete());
    EXPECT_GT(tree.polygons(), 2 * triangles.size()) << "crossing triangles are split";
    const Intrinsics& k = view.intrinsics;
    tree.back_to_front(view.cam_from_origin.center(), [&](const PaintedPolygon& p) {
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            const Eigen::Vector2d at(double(i % std::size_t(k.width)) + 0.5,
                                     double(i / std::size_t(k.width)) + 0.5);
            const auto f = std::ranges::find(pixels[i].fragments, p.triangle + layers.first(),
                                             &TransparentLayers::Fragment::triangle);
            if (f == pixels[i].fragments.end() || f->z > opaque[i]) continue;
            // On the same side of all edges of the piece.
            const Vector3d ray = view.cam_from_origin.R.transpose() *
                                 Vector3d((at.x() - k.cx) / k.fx, (at.y() - k.cy) / k.fy, 1),
                           eye = view.cam_from_origin.center();
            int left = 0, right = 0;
            for (std::size_t c = 0; c < p.corners.size(); ++c) {
                const Vector3d a = p.corners[c] - eye, b = p.corners[(c + 1) % p.corners.size()] - eye;
                const double side = a.cross(b).dot(ray);
                left += side > 0, right += side < 0;
            }
            if (left > 0 && right > 0) continue;
            painted[i].head<3>() = f->alpha * f->color + (1 - f->alpha) * painted[i].head<3>();
            painted[i][3] = f->alpha + (1 - f->alpha) * painted[i][3];
        }
    });
    std::size_t compared = 0, wrong = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (pixels[i].edge || pixels[i].fragments.empty() || crosses(pixels[i].fragments, opaque[i]))
            continue;
        ++compared;
        wrong += codes_apart(exact[i], painted[i]) > 1;
    }
    EXPECT_GT(compared, 5000u);
    EXPECT_LE(double(wrong), 0.001 * double(compared)) << "but for pixels at the cuts of pieces";
}

TEST_F(Transparent, WhatFindsNoRoomIsApproximatedAndCounted) {
    ground();
    for (int i = 0; i < 100; ++i)
        add_quad({-0.7, -3 + 0.02 * i, 1.8}, {1.4, 0, 0}, {0, 0, 1.4},
                 {std::uint8_t(i * 2), 200, std::uint8_t(255 - i), 12});
    const PackageReader package = prepared();
    const gl::HeadlessContext context;
    const auto pixels = TransparentLayers(package).fragments(facing(package));
    const auto behind = [&] {
        Renderer renderer(package, MemoryBudget{});
        return light(renderer, facing(package), shown_as(Transparency::off));
    }();
    const auto mean_error = [&](Renderer& renderer) {
        const auto shown = light(renderer, facing(package), shown_as(Transparency::exact));
        double sum = 0;
        std::size_t compared = 0;
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            if (pixels[i].fragments.size() < 80 || pixels[i].edge) continue;
            sum += codes_apart(shown[i], blended(pixels[i].fragments, behind[i]));
            ++compared;
        }
        EXPECT_GT(compared, 400u);
        return sum / double(compared);
    };
    {
        Renderer renderer(package, MemoryBudget{});
        EXPECT_LT(mean_error(renderer), 1.5) << "what is behind 64 layers hardly shows";
        const FrameReport r = taken(renderer, facing(package), shown_as(Transparency::exact)).report;
        EXPECT_GT(r.fragments, 50'000u);
        std::size_t deep = 0;
        for (const auto& pixel : pixels) deep += std::max<std::size_t>(pixel.fragments.size(), 64) - 64;
        EXPECT_NEAR(double(r.fragments_approximated), double(deep), 0.03 * double(deep));
        const FrameReport four = taken(renderer, facing(package), shown_as(Transparency::exact), 2).report;
        EXPECT_NEAR(double(four.fragments), 4.0 * double(r.fragments), 0.02 * double(r.fragments))
            << "of all samples";
    }
    // Nearer, the stack fills the frame.
    Renderer renderer(package, MemoryBudget{});
    const View near = facing(package, 5);
    const auto shown = light(renderer, near, shown_as(Transparency::exact)),
               approximate = light(renderer, near, shown_as(Transparency::approximate));
    const FrameReport r = taken(renderer, near, shown_as(Transparency::exact)).report;
    EXPECT_GT(r.fragments_approximated, r.fragments * 9 / 10);
    for (std::size_t i = 0; i < shown.size(); ++i)
        ASSERT_LT(codes_apart(shown[i], approximate[i]), 60) << "approximate, not missing";
    const std::string says = (dir / "says").string();
    const std::string command = std::string(VANTAGE_PLAYER) + " " + package.path().string() +
                                " --offscreen --size 64x48 --view 0,-14,2.5,0,0,2.5,5 -o " + says + ".png >" +
                                says + " 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0);
    EXPECT_NE(slurp(says).find("transparent fragments are approximated"), std::string::npos) << slurp(says);
}

TEST_F(Transparent, AWhollyTransparentMeshIsShownWithNothingBehind) {
    input.mesh = {};
    add_quad({-2, 0, 0}, {4, 0, 0}, {0, 0, 4}, {200, 100, 50, 128});
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
            EXPECT_NEAR(p.rgba[middle + 3], 128, 1) << "its alpha; the quad of alpha 0 is invisible";
            const double light = 0.47, red = 255 * encoded(std::pow(200 / 255.0, 2.2) * light);
            EXPECT_NEAR(p.rgba[middle], red, 2) << "straight color";
            EXPECT_EQ(p.rgba[3], 0) << "nothing is there";
        }
    const Picture off = taken(renderer, view, shown_as(Transparency::off));
    EXPECT_TRUE(std::ranges::all_of(off.rgba, [](std::uint8_t c) { return c == 0; }));
    RenderSettings filled = shown_as(Transparency::exact);
    filled.fill_holes = true;
    const Picture over = taken(renderer, view, filled);
    for (std::size_t i = 3; i < over.rgba.size(); i += 4) ASSERT_EQ(over.rgba[i], 255) << "a background";
}

TEST_F(Transparent, NothingOfItIsThereWithoutAlpha) {
    const gl::HeadlessContext context;
    struct Shown {
        std::vector<std::uint8_t> rgba;
        std::uint64_t memory;
        bool symbol, buffer;
        bool operator==(const Shown&) const = default;
    };
    const auto shown = [&](const PackageReader& package) {
        Renderer renderer(package, MemoryBudget{.graphics = std::uint64_t(200) << 20});
        Shown out{taken(renderer, view_of_photo(package.photos()[0], 0.5), {}).rgba, gl::memory_held(), false,
                  false};
        for (GLuint id = 1; id < 2000; ++id) {
            if (glIsProgram(id))
                out.symbol |=
                    glGetUniformLocation(id, "transparent_sums") >= 0 ||
                    glGetUniformLocation(id, "shows_transparent") >= 0 ||
                    glGetUniformLocation(id, "nearness") >= 0 ||
                    glGetProgramResourceIndex(id, GL_SHADER_STORAGE_BLOCK, "Fragments") != GL_INVALID_INDEX;
            char label[64] = "";
            if (glIsBuffer(id)) glGetObjectLabel(GL_BUFFER, id, sizeof label, nullptr, label);
            out.buffer |= std::string(label).starts_with("fragment");
        }
        return out;
    };
    settings.effects[Effect::transparency] = EffectChoice::on;
    const PackageReader forced = prepared("forced");
    EXPECT_FALSE(effect_on(forced.scene(), Effect::transparency)) << "there is nothing to show";
    settings.effects.erase(Effect::transparency);
    const PackageReader none = prepared("none");
    EXPECT_EQ(none.meta().find("transparency"), std::string_view::npos) << "the package of before";
    const Shown bare = shown(none);
    EXPECT_FALSE(bare.symbol || bare.buffer);
    EXPECT_EQ(shown(forced), bare);
    input.mesh.colors.assign(input.mesh.positions.size(), {255, 255, 255, 255});
    const PackageReader opaque = prepared("opaque");
    EXPECT_FALSE(effect_on(opaque.scene(), Effect::transparency));
    EXPECT_EQ(slurp(opaque.path()).find("transparency"), std::string::npos);
    input.mesh.colors[input.mesh.triangles[10][0]][3] = 254;
    settings.effects[Effect::transparency] = EffectChoice::off;
    const PackageReader off = prepared("off");
    EXPECT_FALSE(effect_on(off.scene(), Effect::transparency));
    EXPECT_EQ(shown(off), shown(opaque)) << "as if it had no alpha";
    settings.effects.erase(Effect::transparency);
    const PackageReader on = prepared("on");
    EXPECT_TRUE(effect_on(on.scene(), Effect::transparency));
    const Shown with = shown(on);
    EXPECT_TRUE(with.symbol && with.buffer);
    EXPECT_GT(with.memory, bare.memory);
    for (std::size_t v = 0; v < input.mesh.colors.size(); ++v) input.mesh.colors[v][3] = 0;
    EXPECT_FALSE(effect_on(prepared("unset").scene(), Effect::transparency)) << "alpha was never set";
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
    // What photos see is what they see of the same scene without the case.
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
    // The glass tints what is behind it, and hides nothing.
    const auto picture = [&](const std::string& file, const std::string& options) {
        runs(player + " " + file + " --offscreen --photo 0002 -o " + folder + "/p.png " + options);
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
        // Of what is behind, (1 - 0.3)^1 or ^2 remains, and the glass adds up to 0.47 of its own.
        bright += exact.rgba[i + 1] + 2 >= int(255 * encoded(0.4 * std::pow(off.rgba[i + 1] / 255.0, 2.2)));
        apart += change(approximate, exact) > 40;
        differs += change(approximate, exact) > 0;
    }
    EXPECT_EQ(gone, 0u) << "without the case, the picture is that of the scene without it";
    EXPECT_GT(tinted, 331u * 250 / 20);
    EXPECT_GE(double(bright), 0.99 * double(tinted));
    EXPECT_LT(double(apart), 0.05 * double(tinted));
    EXPECT_GT(differs, 0u);
    // Extracted, the mesh has its alpha.
    runs(vantage + " extract " + package + " -o " + folder + "/files");
    std::vector<std::string> warnings;
    const Mesh back = read_mesh(dir / "files" / "mesh.ply", warnings);
    ASSERT_EQ(back.colors.size(), with.scene().vertices);
    for (std::size_t v = 0; v < back.colors.size(); ++v)
        EXPECT_EQ(int(back.colors[v][3]), v < opaque.vertices ? 255 : 77);
}

TEST_F(Transparent, SurvivesSharesAndRefining) {
    add_quad({-2, -6, 0}, {4, 0, 0}, {0, 0, 4}, {200, 100, 50, 128});
    settings.validate = true;
    const PackageReader whole = prepared();
    for (const std::uint32_t share : {1u, 2u}) {
        PrepareRun run;
        run.share = {share, 2};
        prepare(
            input, settings, dir / (std::to_string(share) + ".share"), [](const Progress&) {}, run);
    }
    merge({dir / "1.share", dir / "2.share"}, dir / "merged.vantage", [](const Progress&) {});
    EXPECT_TRUE(slurp(dir / "merged.vantage") == slurp(whole.path()));
    refine_package(dir / "merged.vantage", {}, dir / "refined.vantage", [](const Progress&) {});
    EXPECT_TRUE(check_package(dir / "refined.vantage", {.deep = true}).empty());
    EXPECT_TRUE(effect_on(PackageReader(dir / "refined.vantage").scene(), Effect::transparency));
}

TEST_F(Transparent, HasNoPartInScores) {
    const auto scores = [&](const std::string& name) {
        prepared(name);
        const std::string file = (dir / name).string();
        const std::string command = std::string(VANTAGE_PLAYER) + " evaluate " + file +
                                    ".vantage --level 2 --photo 0001 -o " + file + "-scores >" + file +
                                    ".txt 2>&1";
        EXPECT_EQ(std::system(command.c_str()), 0) << slurp(file + ".txt");
        return slurp(file + "-scores/photos.csv");
    };
    input.mesh.colors.assign(input.mesh.positions.size(), {255, 255, 255, 255});
    const std::string without = scores("without");
    EXPECT_FALSE(without.empty());
    add_quad({-2, -5, 0.5}, {4, 0, 0}, {0, 0, 4}, {200, 100, 50, 128});
    EXPECT_EQ(scores("with"), without);
}

TEST_F(Transparent, DamagedAlphaIsReported) {
    add_quad({-2, -5, 0.5}, {4, 0, 0}, {0, 0, 4}, {200, 100, 50, 128});
    std::vector<std::uint8_t> bytes;
    std::uint64_t colors = 0;
    settings.effects[Effect::compact] = EffectChoice::off;  // alpha is where it can be changed
    {
        const PackageReader package = prepared();
        colors = package.find(package::Type::colors)->offset;
        const std::string text = slurp(package.path());
        bytes.assign(text.begin(), text.end());
    }
    const auto issues = [&](std::uint64_t vertex, std::uint8_t alpha) {
        std::vector<std::uint8_t> changed = bytes;
        changed[colors + 4 * vertex + 3] = alpha;
        fuzz::fix_checksums(changed);
        std::ofstream(dir / "changed.vantage", std::ios::binary)
            .write(reinterpret_cast<const char*>(changed.data()), std::streamsize(changed.size()));
        return check_package(dir / "changed.vantage", {});
    };
    EXPECT_TRUE(issues(0, 255).empty());
    const auto mixed = issues(0, 254);
    ASSERT_FALSE(mixed.empty());
    EXPECT_NE(mixed[0].text.find("CLUS: triangle"), std::string::npos) << mixed[0].text;
    EXPECT_THROW(make_plan_scene(PackageReader(dir / "changed.vantage")), Error);
}

TEST_F(Transparent, IsLitColoredAndCoveredAsTheModelIs) {
    ground();
    add_quad({-2, -1, 1}, {4, 0, 0}, {0, 0, 2}, {200, 100, 50, 128});
    ScalarLayer layer{"height", {}};
    for (const Vector3d& p : input.mesh.positions)
        layer.values.push_back(p.y() == -1 && p.z() > 0 ? 1.0f : 0.0f);
    input.mesh.scalars.push_back(layer);
    // Points in front of the quad at the left, behind it at the right.
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
    const Vector3d own =
        Vector3d(std::pow(200 / 255.0, 2.2), std::pow(100 / 255.0, 2.2), std::pow(50 / 255.0, 2.2)) * 0.47;
    const double alpha = 128 / 255.0;
    const auto expect_over = [&](const std::pair<RenderSettings, RenderSettings>& s, std::size_t pixel,
                                 const Vector3d& color, const char* what) {
        const Vector4d behind = at(s.second, pixel), shown = at(s.first, pixel);
        const Vector3d expected = alpha * color + (1 - alpha) * behind.head<3>();
        EXPECT_LT((shown.head<3>() - expected).norm(), 0.01) << what << ": " << shown.transpose();
    };
    expect_over(with([](RenderSettings&) {}), left, own, "over photos");
    expect_over(with([](RenderSettings& s) { s.light.light = Light::lamp; }), left,
                Vector3d::Constant(shader::light_gray), "bare geometry faces the lamp");
    expect_over(with([](RenderSettings& s) { s.light.light = Light::lamp, s.light.on_photos = true; }), left,
                own, "its own color, times the light");
    const auto shows_points = with([](RenderSettings& s) { s.points.show = true, s.points.eye_dome = 0; });
    EXPECT_EQ(at(shows_points.first, left), at(shows_points.second, left)) << "points are in front of it";
    expect_over(shows_points, right, own, "points behind it");
    const auto alone = with([](RenderSettings& s) { s.points.alone = s.points.show = true; });
    EXPECT_EQ(at(alone.first, right), at(alone.second, right)) << "points alone";
    const auto layered = with([](RenderSettings& s) { s.layer.layer = 0; });
    const Vector4d shown = at(layered.first, left), behind = at(layered.second, left);
    EXPECT_GT((shown - behind).norm(), 0.2) << "the end of the color map over its beginning";
    const auto counted = with([](RenderSettings& s) { s.show = Show::coverage; });
    EXPECT_EQ(at(counted.first, left), at(counted.second, left)) << "counts have no colors over them";
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
            const double covers = without.rgba[4 * i + 3] / 255.0;  // beyond the background, nothing does
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
