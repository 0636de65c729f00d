// Compares point clouds shown with the model with points projected one by one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <numeric>
#include <random>

#include "base/gl/context.h"
#include "pipeline/formats/cloud.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/mesh/ray_scene.h"
#include "pipeline/prepare/merge_packages.h"
#include "pipeline/prepare/prepare.h"
#include "pipeline/prepare/refine_package.h"
#include "pipeline/reports/check.h"
#include "pipeline/reports/extract.h"
#include "pipeline/run/until_stopped.h"
#include "pipeline/synth/synthesize.h"
#include "player/render/picture.h"
#include "player/view/stereo.h"
#include "scene/package/contents/point_cloud.h"
#include "tests/made_scenes.h"
#include "tests/temporary_folder.h"

using namespace vantage;

namespace {

using PointCode = std::array<std::uint8_t, 4>;

/// A small building, with points around and inside it.
class Points : public TemporaryFolder {
  protected:
    void SetUp() override {
        TemporaryFolder::SetUp();
        SynthSpec spec = tiny_spec();
        copy_scene(spec, dir / "scene");
        input = read_scene(discover(dir / "scene"));
    }
    void scatter(std::size_t count) {
        std::mt19937 random(3);
        std::uniform_real_distribution<double> across(-7, 7), up(-1, 9);
        std::uniform_int_distribution<int> code(0, 255);
        for (std::size_t i = 0; i < count; ++i) {
            input.points.positions.emplace_back(across(random), across(random), up(random));
            input.points.colors.push_back({std::uint8_t(code(random)), std::uint8_t(code(random)), 60, 255});
        }
        input.files.points = {dir / "cloud.ply"};
        std::ofstream(dir / "cloud.ply") << "cloud";
    }
    PackageReader prepared(const std::string& name = "scene", const PrepareSettings& settings = {},
                           const PrepareRun& run = {}) const {
        prepare(
            input, settings, dir / (name + ".vantage"), [](const Progress&) {}, run);
        return PackageReader(dir / (name + ".vantage"));
    }
    static std::vector<std::uint32_t> all(const PackageReader& package) {
        std::vector<std::uint32_t> photos(package.photos().size());
        std::iota(photos.begin(), photos.end(), 0u);
        return photos;
    }
    static Picture taken(Renderer& renderer, const View& view, const RenderSettings& settings) {
        return take_picture(renderer, view, settings, all(renderer.package()), 1);
    }
    SceneInput input;
};
class PointsAtLength : public Points {};

/// Settings for one-pixel points in their own colors, without shading.
RenderSettings plain() {
    RenderSettings s;
    s.points.by = PointSize::pixels;
    s.points.size = 1;
    s.points.eye_dome = 0;
    return s;
}

PointCode code_at(const Picture& p, std::size_t pixel) {
    return {p.rgba[4 * pixel], p.rgba[4 * pixel + 1], p.rgba[4 * pixel + 2], p.rgba[4 * pixel + 3]};
}

bool is_near(const PointCode& a, const PointCode& b) {
    for (std::size_t c = 0; c < 3; ++c)
        if (std::abs(int(a[c]) - int(b[c])) > 1) return false;
    return true;
}

/// The depth and color of the nearest point at a pixel.
struct Nearest {
    double z = 1e300, next = 1e300;  ///< depths of the nearest and the second nearest point
    PointCode color{};
};

std::vector<Nearest> projected(const Mesh& points, const Eigen::Vector3d& origin, const View& view) {
    std::vector<Nearest> out(std::size_t(view.intrinsics.width) * std::size_t(view.intrinsics.height));
    for (std::size_t i = 0; i < points.positions.size(); ++i) {
        const auto at = project(view.intrinsics, view.cam_from_origin, points.positions[i] - origin);
        if (!at || !(at->pixel.x() >= 0 && at->pixel.y() >= 0 && at->pixel.x() < view.intrinsics.width &&
                     at->pixel.y() < view.intrinsics.height))
            continue;
        Nearest& n =
            out[std::size_t(at->pixel.y()) * std::size_t(view.intrinsics.width) + std::size_t(at->pixel.x())];
        if (at->z < n.z)
            n = {at->z, n.z, points.colors[i]};
        else
            n.next = std::min(n.next, at->z);
    }
    return out;
}

}  // namespace

TEST_F(Points, AreWhereProjectionPutsThemBeforeAndBehindTheModel) {
    scatter(60'000);
    const PackageReader package = prepared();
    ASSERT_TRUE(effect_on(package.scene(), Effect::points));
    const gl::HeadlessContext context;
    Renderer renderer(package, MemoryBudget{});
    const View view = view_of_photo(package.photos()[1], 1);
    const Eigen::Vector3d origin = Eigen::Map<const Eigen::Vector3d>(package.scene().origin);
    const std::vector<Nearest> expected = projected(input.points, origin, view);
    RenderSettings settings = plain(), without = plain();
    without.points.show = false;
    const Picture with_model = taken(renderer, view, settings), model = taken(renderer, view, without);
    settings.points.alone = true;
    const Picture alone = taken(renderer, view, settings);
    const RayScene mesh(input.mesh);
    const Intrinsics& k = view.intrinsics;
    std::size_t shown = 0, right = 0, empty = 0, clear = 0, compared = 0, in_order = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const Nearest& n = expected[i];
        if (n.z > 1e200) {
            ++empty;
            clear += code_at(alone, i)[3] == 0;
            continue;
        }
        if (n.next - n.z < 1e-4) continue;
        ++shown;
        right += is_near(code_at(alone, i), n.color);
        // The model's depth is taken where the ray through the pixel's center meets the model.
        const Eigen::Vector3d ray((double(i % std::size_t(k.width)) + 0.5 - k.cx) / k.fx,
                                  (double(i / std::size_t(k.width)) + 0.5 - k.cy) / k.fy, 1);
        const Eigen::Matrix3d turned = view.cam_from_origin.R.transpose();
        const auto hit = mesh.first_hit(view.cam_from_origin.center() + origin, turned * ray);
        if (hit && std::abs(hit->distance - n.z) < 0.3) continue;  // near an edge, the order may differ
        ++compared;
        const bool behind = hit && hit->distance < n.z;
        in_order += is_near(code_at(with_model, i), behind ? code_at(model, i) : n.color);
    }
    EXPECT_GT(shown, 10'000u);
    EXPECT_GT(compared, 5'000u);
    // Graphics cards round positions to 1/256 px, so points near the border between two pixels may be in
    // either pixel.
    EXPECT_GE(double(right), 0.99 * double(shown));
    EXPECT_GE(double(clear), 0.998 * double(empty));
    EXPECT_GE(double(in_order), 0.99 * double(compared));
}

TEST_F(Points, FillGapsOfASheetWhateverTheBudget) {
    for (int x = 0; x < 400; ++x)
        for (int y = 0; y < 400; ++y) {
            input.points.positions.emplace_back(-6 + 0.03 * x, -7, -2 + 0.03 * y);
            input.points.colors.push_back({200, 40, 40, 255});
        }
    input.files.points = {dir / "cloud.ply"};
    std::ofstream(dir / "cloud.ply") << "cloud";
    const PackageReader package = prepared();
    const gl::HeadlessContext context;
    Renderer renderer(package, MemoryBudget{});
    const Eigen::Vector3d origin = Eigen::Map<const Eigen::Vector3d>(package.scene().origin);
    const View view = view_towards(Eigen::Vector3d(0, -12, 4) - origin, Eigen::Vector3d(0, -7, 4) - origin,
                                   {0, 0, 1}, 60, 400, 300);
    for (const std::uint64_t budget : {10'000ull, 50'000ull, 1'000'000ull}) {
        RenderSettings settings;
        settings.points.alone = true;
        settings.points.eye_dome = 0;
        settings.points.budget = budget;
        const Picture picture = taken(renderer, view, settings);
        EXPECT_LE(picture.report.points, std::max<std::uint64_t>(budget, package::point_node));
        std::size_t red = 0;
        for (std::size_t i = 0; i < picture.rgba.size() / 4; ++i)
            red += is_near(code_at(picture, i), {200, 40, 40, 255});
        EXPECT_GT(double(red), 0.995 * double(picture.rgba.size() / 4)) << budget;
    }
}

TEST_F(Points, OfTwoEyesHideAndAreHiddenAsForOne) {
    scatter(3000);
    const PackageReader package = prepared();
    const gl::HeadlessContext context;
    Renderer renderer(package, MemoryBudget{});
    const auto both =
        eye_views(view_of_photo(package.photos()[0], 0.5), {.distance = 0.4, .convergence = 6}, 1);
    // Without points, each eye has its own surface buffer; with points, both eyes share one buffer.
    for (const bool shown : {false, true, false}) {
        RenderSettings s = plain();
        s.points.show = shown;
        std::array<Picture, 2> pair;
        FrameReport report = renderer.prepare({both, s, all(package)});
        for (const std::size_t eye : {0, 1}) {
            renderer.paint(eye, report);
            pair[eye] = picture_of(frame_size(both[eye]), [&](GLuint target) {
                renderer.show(both[eye], s, {target, false, eye});
            });
        }
        for (const std::size_t eye : {0, 1})
            EXPECT_EQ(pair[eye].rgba, taken(renderer, both[eye], s).rgba)
                << "eye " << eye << ", points " << shown;
        EXPECT_NE(pair[0].rgba, pair[1].rgba);
    }
}

TEST_F(Points, NothingOfThemIsThereWhenTheyAreOff) {
    const gl::HeadlessContext context;
    const auto shown = [&](const PackageReader& package) {
        Renderer renderer(package, MemoryBudget{.graphics = std::uint64_t(200) << 20});
        const Picture picture = taken(renderer, view_of_photo(package.photos()[0], 0.5), {});
        return std::pair(picture.rgba, gl::memory_held());
    };
    PrepareSettings forced;
    forced.effects[Effect::points] = EffectChoice::on;
    const PackageReader none = prepared("none", forced);
    EXPECT_FALSE(effect_on(none.scene(), Effect::points)) << "nothing to show";
    const auto bare = shown(none);
    scatter(1000);
    PrepareSettings off;
    off.effects[Effect::points] = EffectChoice::off;
    const PackageReader without = prepared("off", off);
    EXPECT_FALSE(without.find(package::Type::point_nodes));
    EXPECT_FALSE(without.find(package::Type::points));
    EXPECT_EQ(shown(without), bare);
    const PackageReader with = prepared("on");
    EXPECT_TRUE(with.find(package::Type::points));
    EXPECT_GT(shown(with).second, bare.second);
}

TEST_F(Points, SurviveSharesRefiningExtractingAndChecking) {
    scatter(50'000);
    const PackageReader whole = prepared();
    for (const std::uint32_t share : {1u, 2u}) {
        PrepareRun run;
        run.share = {share, 2};
        prepare(
            input, {}, dir / (std::to_string(share) + ".share"), [](const Progress&) {}, run);
    }
    merge({dir / "1.share", dir / "2.share"}, dir / "merged.vantage", [](const Progress&) {});
    EXPECT_TRUE(slurp(dir / "merged.vantage") == slurp(whole.path()));
    refine_package(dir / "merged.vantage", {}, dir / "refined.vantage", [](const Progress&) {});
    const PackageReader refined(dir / "refined.vantage");
    EXPECT_TRUE(check_package(refined.path(), {.deep = true}).empty());
    EXPECT_EQ(read_point_cloud(refined)->points, 50'000u);
    extract(whole.path(), dir / "files", {}, false);
    std::vector<std::string> warnings;
    const Mesh back = read_cloud(dir / "files" / "points.ply", warnings);
    ASSERT_EQ(back.positions.size(), 50'000u);
    const auto sorted = [](const Mesh& m) {
        std::vector<std::array<double, 4>> out;
        for (std::size_t i = 0; i < m.positions.size(); ++i)
            out.push_back({std::round(m.positions[i].x() * 1e4), std::round(m.positions[i].y() * 1e4),
                           std::round(m.positions[i].z() * 1e4), double(m.colors[i][0])});
        std::ranges::sort(out);
        return out;
    };
    const auto a = sorted(back), b = sorted(input.points);
    std::size_t same = 0;
    for (std::size_t i = 0; i < a.size(); ++i) same += std::abs(a[i][0] - b[i][0]) < 2 && a[i][3] == b[i][3];
    EXPECT_GT(double(same), 0.99 * double(a.size()))
        << "only points that are rounded the other way may differ";
}

TEST_F(Points, DamagedOnesAreReportedAndTheOthersShown) {
    scatter(150'000);
    std::uint64_t at = 0;
    {
        const PackageReader package = prepared();
        const package::DirectoryEntry* e = package.find(package::Type::points);
        ASSERT_GT(package.blocks(*e), 2u);
        at = e->offset + e->head_length + 2 * e->block_length + 12345;
    }
    std::fstream(dir / "scene.vantage", std::ios::in | std::ios::out | std::ios::binary)
            .seekp(std::streamoff(at))
        << "rot";
    EXPECT_FALSE(check_package(dir / "scene.vantage", {.deep = true}).empty());
    const PackageReader package(dir / "scene.vantage");
    const gl::HeadlessContext context;
    Renderer renderer(package, MemoryBudget{});
    const Picture picture = taken(renderer, view_of_photo(package.photos()[1], 1), plain());
    EXPECT_EQ(picture.report.tiles_damaged, 1u);
    EXPECT_EQ(picture.report.nodes_missing, 0u) << "the renderer should not wait for a damaged block";
    EXPECT_GT(picture.report.points, 30'000u);
}

TEST_F(PointsAtLength, HaveNoPartInScores) {
    const auto scores = [&](const std::string& name) {
        prepared(name);
        const std::string file = (dir / name).string();
        const std::string command = std::string(VANTAGE_PLAYER) + " evaluate " + file +
                                    ".vantage --level 2 --photo 0001 -o " + file + "-scores >" + file +
                                    ".txt 2>&1";
        EXPECT_EQ(std::system(command.c_str()), 0) << slurp(file + ".txt");
        return slurp(file + "-scores/photos.csv");
    };
    const std::string without = scores("without");
    EXPECT_FALSE(without.empty());
    scatter(20'000);
    EXPECT_EQ(scores("with"), without);
}
