// Tests point-only scenes, with and without photos. The ground truth is the mesh from which the points are
// sampled, shown with the same photos, as well as the points themselves, projected one by one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <numeric>
#include <random>

#include "base/gl/context.h"
#include "pipeline/formats/export_ply.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/prepare/merge_packages.h"
#include "pipeline/prepare/prepare.h"
#include "pipeline/prepare/refine_package.h"
#include "pipeline/reports/check.h"
#include "pipeline/reports/extract.h"
#include "pipeline/run/until_stopped.h"
#include "player/render/picture.h"
#include "player/view/camera_path.h"
#include "player/view/navigation.h"
#include "scene/package/contents/point_cloud.h"
#include "tests/made_scenes.h"
#include "tests/temporary_folder.h"

using namespace vantage;

namespace {

constexpr std::array<std::uint8_t, 3> magenta{255, 0, 255};

/// A scan with a point cloud in place of the small building's mesh.
class PointScenes : public TemporaryFolder {
  protected:
    void SetUp() override {
        TemporaryFolder::SetUp();
        SynthSpec spec = tiny_spec();
        copy_scene(spec, dir / "scene");
        with_mesh = read_scene(discover(dir / "scene"));
        mesh_file = with_mesh.files.mesh;
    }
    /// Magenta points, uniformly distributed over the mesh.
    std::vector<PlyPoint> samples(std::size_t count) const {
        const Mesh& m = with_mesh.mesh;
        std::vector<double> areas;
        for (const auto& t : m.triangles)
            areas.push_back(
                (m.positions[t[1]] - m.positions[t[0]]).cross(m.positions[t[2]] - m.positions[t[0]]).norm());
        std::mt19937 random(5);
        std::discrete_distribution<std::size_t> triangle(areas.begin(), areas.end());
        std::uniform_real_distribution<double> share;
        std::vector<PlyPoint> out;
        for (std::size_t i = 0; i < count; ++i) {
            const auto& t = m.triangles[triangle(random)];
            double a = share(random), b = share(random);
            if (a + b > 1) a = 1 - a, b = 1 - b;
            const Eigen::Vector3d &o = m.positions[t[0]], &p = m.positions[t[1]], &q = m.positions[t[2]];
            out.push_back({o + a * (p - o) + b * (q - o), magenta});
        }
        return out;
    }
    /// Replaces the mesh file with a point cloud.
    void put_cloud(const std::vector<PlyPoint>& points) {
        std::filesystem::remove(mesh_file);
        write_points_ply(dir / "scene" / "cloud.ply", points.size(), [&](const auto& put) {
            for (const PlyPoint& p : points) put(p);
        });
    }
    PackageReader prepared(const std::string& name, const PrepareRun& run = {}) const {
        prepare(
            read_scene(discover(dir / "scene")), {}, dir / name, [](const Progress&) {}, run);
        return PackageReader(dir / name);
    }
    static Picture taken(const PackageReader& package, const View& view, const RenderSettings& settings) {
        Renderer renderer(package, MemoryBudget{});
        std::vector<std::uint32_t> photos(package.photos().size());
        std::iota(photos.begin(), photos.end(), 0u);
        return take_picture(renderer, view, settings, photos, 1);
    }
    static bool is_magenta(const Picture& p, std::size_t pixel) {
        return p.rgba[4 * pixel] > 150 && p.rgba[4 * pixel + 1] < 90 && p.rgba[4 * pixel + 2] > 150;
    }
    SceneInput with_mesh;
    std::filesystem::path mesh_file;
};

/// The mean difference of 8-bit values at pixels that are colored in both pictures. `share` receives
/// the fraction of the pixels colored in `truth` that are also colored in `p`.
double difference(const Picture& truth, const Picture& p, double& share) {
    double sum = 0;
    std::size_t both = 0, shown = 0;
    for (std::size_t i = 0; i < truth.rgba.size(); i += 4) {
        shown += truth.rgba[i + 3] > 0;
        if (!truth.rgba[i + 3] || !p.rgba[i + 3]) continue;
        ++both;
        for (std::size_t c = 0; c < 3; ++c)
            sum += std::abs(int(truth.rgba[i + c]) - int(p.rgba[i + c])) / 3.0;
    }
    share = double(both) / double(std::max<std::size_t>(1, shown));
    return sum / double(std::max<std::size_t>(1, both));
}

}  // namespace

TEST_F(PointScenes, LookLikeTheMeshWithTheSamePhotos) {
    PrepareSettings settings;
    settings.effects[Effect::background] = EffectChoice::off;
    prepare(with_mesh, settings, dir / "mesh.vantage", [](const Progress&) {}, {});
    const PackageReader mesh(dir / "mesh.vantage");
    put_cloud(samples(300'000));
    const PackageReader cloud = prepared("cloud.vantage");
    ASSERT_TRUE(points_only(cloud.scene()));
    const gl::HeadlessContext context;
    const Eigen::Vector3d moved = Eigen::Map<const Eigen::Vector3d>(mesh.scene().origin) -
                                  Eigen::Map<const Eigen::Vector3d>(cloud.scene().origin);
    for (const double beside : {0.0, 0.5}) {
        const Navigation there = between(stand_at(mesh.photos()[1], up_of(mesh.scene())),
                                         stand_at(mesh.photos()[2], up_of(mesh.scene())), beside);
        const View view = view_of(there, 320, 240);
        View same_view = view;
        same_view.cam_from_origin.t -= view.cam_from_origin.R * moved;
        const Picture truth = taken(mesh, view, {}), found = taken(cloud, same_view, {});
        double share = 0;
        EXPECT_LT(difference(truth, found, share), 8) << beside;
        EXPECT_GT(share, 0.98) << beside;
        std::size_t own = 0, shown = 0;
        for (std::size_t i = 0; i < found.rgba.size() / 4; ++i)
            own += is_magenta(found, i), shown += found.rgba[4 * i + 3] > 0;
        EXPECT_LT(double(own), 0.1 * double(shown)) << beside;
        RenderSettings bare;
        bare.points.color = PointColor::own;
        const Picture own_colors = taken(cloud, same_view, bare);
        EXPECT_GT(difference(truth, own_colors, share), 40)
            << "the points' own colors should differ from the photos";
    }
}

TEST_F(PointScenes, TheFirstFrameOfAWindowShowsTheWholeCloudCoarsely) {
    put_cloud(samples(300'000));
    const PackageReader package = prepared("cloud.vantage");
    const gl::HeadlessContext context;
    const View view = view_of(home_of(package, 0), 320, 240);
    const Picture all = taken(package, view, {});
    RenderSettings window;
    window.loading = Loading::streamed;
    window.upload_bytes = 1;  // a block, at most
    const Picture first = taken(package, view, window);
    EXPECT_LT(first.report.points, all.report.points) << "the rest follows";
    double share = 0;
    difference(all, first, share);
    EXPECT_GT(share, 0.95);
}

TEST_F(PointScenes, WhatNoPhotoSeesKeepsItsOwnColor) {
    // A sheet inside the building; the walls hide it from all viewpoints outside.
    std::vector<PlyPoint> points = samples(200'000);
    for (int x = 0; x < 200; ++x)
        for (int z = 0; z < 200; ++z) points.push_back({{-1 + 0.01 * x, 2, 2 + 0.01 * z}, magenta});
    put_cloud(points);
    const PackageReader package = prepared("cloud.vantage");
    const gl::HeadlessContext context;
    const Eigen::Vector3d origin = Eigen::Map<const Eigen::Vector3d>(package.scene().origin);
    const View inside = view_towards(Eigen::Vector3d(0, 1, 3) - origin, Eigen::Vector3d(0, 2, 3) - origin,
                                     {0, 0, 1}, 40, 160, 120);
    RenderSettings settings;
    settings.points.eye_dome = 0;
    const Picture p = taken(package, inside, settings);
    std::size_t own = 0;
    for (std::size_t i = 0; i < p.rgba.size() / 4; ++i) own += is_magenta(p, i);
    EXPECT_GT(double(own), 0.98 * double(p.rgba.size() / 4));
}

TEST_F(PointScenes, AreSharedMergedRefinedCheckedAndExtracted) {
    put_cloud(samples(40'000));
    const PackageReader whole = prepared("whole.vantage");
    for (const std::uint32_t share : {1u, 2u}) {
        PrepareRun run;
        run.share = {share, 2};
        prepare(
            read_scene(discover(dir / "scene")), {}, dir / (std::to_string(share) + ".share"),
            [](const Progress&) {}, run);
    }
    merge({dir / "1.share", dir / "2.share"}, dir / "merged.vantage", [](const Progress&) {});
    EXPECT_TRUE(slurp(dir / "merged.vantage") == slurp(whole.path()));
    refine_package(whole.path(), {}, dir / "refined.vantage", [](const Progress&) {});
    EXPECT_TRUE(check_package(dir / "refined.vantage", {.deep = true}).empty());
    EXPECT_TRUE(points_only(PackageReader(dir / "refined.vantage").scene()));
    extract(whole.path(), dir / "files", {}, false);
    EXPECT_TRUE(std::filesystem::exists(dir / "files" / "points.ply"));
    EXPECT_FALSE(std::filesystem::exists(dir / "files" / "mesh.ply"))
        << "the substitute mesh should not be exported";
}

TEST_F(PointScenes, NeedNoPhotos) {
    put_cloud(samples(20'000));
    for (const char* part : {"images", "sparse", "truth"}) std::filesystem::remove_all(dir / "scene" / part);
    const std::string at = dir.string();
    const auto run = [&](const std::string& command) {
        const int status = std::system((command + " >>" + at + "/log.txt 2>&1").c_str());
        EXPECT_EQ(status, 0) << command << "\n" << slurp(dir / "log.txt");
    };
    const std::string player = VANTAGE_PLAYER, package = at + "/c.vantage";
    run(std::string(VANTAGE_PROGRAM) + " prepare " + at + "/scene -o " + package);
    run(std::string(VANTAGE_PROGRAM) + " check --deep --against " + at + "/scene " + package);
    run(player + " render " + package + " --view 0,-14,5,0,0,3 --size 200x150 -o " + at + "/p.png");
    run(player + " verify " + package + " --golden " + at + "/golden --update");
    run(player + " verify " + package + " --golden " + at + "/golden");
    const Picture p = read_png(dir / "p.png");
    std::size_t shown = 0;
    for (std::size_t i = 3; i < p.rgba.size(); i += 4) shown += p.rgba[i] > 0;
    EXPECT_GT(shown, p.rgba.size() / 4 / 10);
    // If the points' z axis points down, a view that is rolled by half a turn is upright.
    run(player + " render " + package + " --view 0,-14,5,0,0,3,45,180 --size 200x150 -o " + at +
        "/rolled.png");
    const Picture rolled = read_png(dir / "rolled.png");
    std::size_t differing = 0;
    for (std::size_t i = 0, n = p.rgba.size() / 4; i < n; ++i)
        differing += std::abs(p.rgba[4 * i + 3] - rolled.rgba[4 * (n - 1 - i) + 3]) > 64;
    EXPECT_LT(differing, shown / 50);
    // In the window's first view, the whole cloud must be in the frame.
    const PackageReader reader(package);
    const View home = view_of(home_of(reader, 0), 320, 240);
    const Eigen::Vector3d origin = Eigen::Map<const Eigen::Vector3d>(reader.scene().origin);
    for (const PlyPoint& point : samples(2000)) {
        const auto pixel = project(home.intrinsics, home.cam_from_origin, point.position - origin);
        ASSERT_TRUE(pixel) << point.position.transpose();
        EXPECT_GE(pixel->pixel.minCoeff(), 0) << point.position.transpose();
        EXPECT_LT(pixel->pixel.x(), 320) << point.position.transpose();
        EXPECT_LT(pixel->pixel.y(), 240) << point.position.transpose();
    }
}

TEST_F(PointScenes, AreObjectsOfASceneBeforeAndBehindOthers) {
    // A wall of points in front of the building, whose front is at about y = -3.
    std::vector<PlyPoint> wall;
    for (int x = -100; x <= 100; ++x)
        for (int z = 0; z <= 100; ++z) wall.push_back({{0.02 * x, -5, 0.03 * z}, magenta});
    write_points_ply(dir / "wall.ply", wall.size(), [&](const auto& put) {
        for (const PlyPoint& p : wall) put(p);
    });
    const std::string at = dir.string();
    std::ofstream(dir / "s.toml") << "[[object]]\ninput = \"scene\"\n[[object]]\npoints = \"wall.ply\"\n";
    const auto run = [&](const std::string& command) {
        const int status = std::system((command + " >>" + at + "/log.txt 2>&1").c_str());
        ASSERT_EQ(status, 0) << command << "\n" << slurp(dir / "log.txt");
    };
    run(VANTAGE_PROGRAM " prepare " + at + "/s.toml -o " + at + "/out");
    std::ofstream(dir / "t.toml")
        << "[[object]]\npackage = \"out/wall.vantage\"\n[[object]]\npackage = \"out/scene.vantage\"\n";
    for (const std::string scene : {"/out/s.toml", "/t.toml"}) {
        const auto magenta_share = [&](const std::string& view) {
            run(VANTAGE_PLAYER " render " + at + scene + " --holes shade --size 200x150 --view " + view +
                " -o " + at + "/p.png");
            const Picture p = read_png(dir / "p.png");
            std::size_t n = 0;
            for (std::size_t i = 0; i < p.rgba.size() / 4; ++i) n += is_magenta(p, i);
            return double(n) / double(p.rgba.size() / 4);
        };
        EXPECT_NEAR(magenta_share("0,-14,1.5,0,0,1.5"), 0.163, 0.02)
            << "the wall should be in its place in front of the building";
        EXPECT_EQ(magenta_share("0,14,1.5,0,0,1.5"), 0) << "the building should hide the wall";
    }
}

TEST_F(PointScenes, APickedPointHasTheCoordinatesAndColorOfTheNearestOneAtThePixel) {
    std::vector<PlyPoint> points = samples(30'000);
    for (std::size_t i = 0; i < points.size(); ++i)
        points[i].color = {std::uint8_t(i), std::uint8_t(i >> 8), 7};
    put_cloud(points);
    const PackageReader package = prepared("cloud.vantage");
    const gl::HeadlessContext context;
    Renderer renderer(package, MemoryBudget{});
    const View view = view_of_photo(package.photos()[1], 1);
    RenderSettings settings;
    settings.points.by = PointSize::pixels;
    settings.points.size = 1;
    settings.points.pick = true;
    take_picture(renderer, view, settings, {}, 1);
    const Eigen::Vector3d origin = Eigen::Map<const Eigen::Vector3d>(package.scene().origin);
    const int width = view.intrinsics.width, height = view.intrinsics.height;
    std::vector<std::pair<double, std::size_t>> nearest(std::size_t(width) * std::size_t(height), {1e300, 0});
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto at = project(view.intrinsics, view.cam_from_origin, points[i].position - origin);
        if (!at ||
            !(at->pixel.x() >= 0 && at->pixel.y() >= 0 && at->pixel.x() < width && at->pixel.y() < height))
            continue;
        auto& n = nearest[std::size_t(at->pixel.y()) * std::size_t(width) + std::size_t(at->pixel.x())];
        n = std::min(n, {at->z, i});
    }
    const auto answer = [&](std::size_t pixel) {
        const Eigen::Vector2i at(int(pixel) % width, int(pixel) / width);
        for (int i = 0; i < 3; ++i) renderer.pick(at), glFinish();
        return renderer.picked();
    };
    std::size_t asked = 0, right = 0, empty = 0, nothing = 0;
    for (std::size_t pixel = 0; pixel < nearest.size(); pixel += 97) {
        const auto found = answer(pixel);
        if (nearest[pixel].first > 1e200) {
            ++empty, nothing += !found;
            continue;
        }
        const PlyPoint& truth = points[nearest[pixel].second];
        ++asked;
        right += found && (found->position - truth.position).norm() < 1e-4 && found->color == truth.color;
    }
    EXPECT_GT(asked, 50u);
    EXPECT_GE(double(right), 0.97 * double(asked))
        << "only points on the border between two pixels may differ";
    EXPECT_GE(double(nothing), 0.97 * double(empty));
    renderer.pick({-1, 5});
    renderer.pick({-1, 5});
    EXPECT_FALSE(renderer.picked()) << "outside the frame";
}
