// Compares visibility at difficult depths with double-precision ray casting against every triangle and with
// closed-form results.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/mesh/clusters.h"
#include "pipeline/prepare/prepare.h"
#include "pipeline/visibility/frame_triangles.h"
#include "player/plan/cluster_tree.h"
#include "player/render/picture.h"
#include "scene/package/package_reader.h"
#include "tests/hard_cases/depth/triangle_soup.h"
#include "tests/made_scenes.h"

using namespace vantage;

TEST_F(Depth, EveryPixelMatchesItsFirstRayHit) {
    // Large and small triangles and slivers around the camera, some of them behind it or crossing the plane
    // through its center.
    for (unsigned seed = 1; seed <= 6; ++seed) {
        Random random(seed);
        Soup soup;
        for (int t = 0; t < 160; ++t) {
            const double size = std::pow(10, random(-1.5, t % 8 ? 0.3 : 1.3));
            const Eigen::Vector3d center = 5 * random.vector();
            const Eigen::Vector3d a = center + size * random.vector(), b = center + size * random.vector();
            const Eigen::Vector3d along = a + random(0, 1) * (b - a);
            soup.add(a, b, t % 3 ? center + size * random.vector() : along + 1e-4 * size * random.vector());
        }
        const Pose pose{random.rotation(), 0.5 * random.vector()};
        for (const Seen& s : seen(soup, depth_camera, pose))
            EXPECT_EQ(count_wrong(s.geometry, soup, depth_camera, pose, 1 / 64.0), 0u)
                << s.by << " seed " << seed;
    }
}

TEST_F(Depth, DepthsAreExactOverANearFarRatioOfAMillion) {
    // There are surfaces on both sides of the camera, so that single precision suffices for the near ones.
    // Each strip of the frame has its own distance, and a second surface behind the first at 1.001 times its
    // distance.
    Soup soup;
    for (const double side : {-1.0, 1.0})
        for (int strip = 0; strip < 7; ++strip) {
            const double z = side * std::pow(10, strip);
            for (const double behind : {1.001, 1.0})
                soup.add_square(
                    behind * z *
                        Eigen::Vector3d((10 + 20 * strip - depth_camera.cx) / depth_camera.fx, -1, 1),
                    behind * z * Eigen::Vector3d(19 / depth_camera.fx, 0, 0),
                    behind * z * Eigen::Vector3d(0, 2, 0));
        }
    for (const Seen& s : seen(soup, depth_camera, Pose{}))
        for (int y = 0; y < s.geometry.height; ++y)
            for (int strip = 0; strip < 7; ++strip) {
                const auto x = std::size_t(5 + 10 * strip + 4);
                const double z = std::pow(10, strip);
                ASSERT_NEAR(s.geometry.z[std::size_t(y) * std::size_t(s.geometry.width) + x], z, 1e-4 * z)
                    << s.by << " row " << y;
            }
}

TEST_F(Depth, ClosedModelHasNoHolesFromInside) {
    // A cube around the camera, whose position is close to two of the cube's sides.
    const double half = 4;
    Soup soup;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-half, half}) {
            Eigen::Vector3d corner = Eigen::Vector3d::Constant(-half), u = Eigen::Vector3d::Zero(), v = u;
            corner[axis] = side;
            u[(axis + 1) % 3] = v[(axis + 2) % 3] = 2 * half;
            soup.add_square(corner, u, v);
        }
    Random random(5);
    for (int turn = 0; turn < 8; ++turn) {
        const Eigen::Vector3d eye(3.9, random(-3.9, 3.9), 3.98);
        Pose pose{random.rotation(), {}};
        pose.t = -pose.R * eye;
        for (const Seen& s : seen(soup, depth_camera, pose)) {
            // OpenGL positions have only 24 bits, and the offset to the near side uses up some of them.
            EXPECT_LE(count_wrong(s.geometry, soup, depth_camera, pose, 1 / 64.0), s.by[0] == 'O' ? 4u : 0u)
                << s.by << " turn " << turn;
            EXPECT_TRUE(std::ranges::all_of(s.geometry.z, [](float z) { return std::isfinite(z); })) << s.by;
        }
        const auto found = coordinates(soup, depth_camera, pose);
        for (std::size_t v = 0; v < found.size(); ++v) {
            const auto at = project(depth_camera, pose, soup.positions[v].cast<double>());
            EXPECT_EQ(found[v].x() >= 0, at && in_frame(depth_camera, at->pixel))
                << "turn " << turn << " vertex " << v;
        }
    }
}

// Clamping corners to the frame would bend the edges.
TEST_F(Depth, HugeFloorKeepsItsDepth) {
    Soup soup;
    soup.add({-1e6, 1, -3}, {2e6, 1, -7}, {-3e5, 1, 10});
    for (const Seen& s : seen(soup, depth_camera, Pose{}))
        EXPECT_EQ(count_wrong(s.geometry, soup, depth_camera, Pose{}, 1 / 64.0), 0u) << s.by;
}

TEST_F(Depth, VertexVisibilityMatchesRayCastingAtAllDistances) {
    // Triangles and slivers at distances from 1 to a million, of similar sizes in pixels.
    std::size_t visible = 0, hidden = 0, differ = 0;
    for (unsigned seed = 1; seed <= 3; ++seed) {
        Random random(seed);
        Soup soup;
        for (int t = 0; t < 700; ++t) {
            const double z = std::pow(10, random(0, 6)) * (t % 9 ? 1 : -1),
                         size = std::pow(10, random(-2.3, -0.7));
            const auto corner = [&](const Eigen::Vector3d& c) {
                return Eigen::Vector3d(z * (c + size * random.vector()));
            };
            const Eigen::Vector3d c(random(-0.7, 0.7), random(-0.5, 0.5), 1);
            const Eigen::Vector3d a = corner(c), b = corner(c);
            soup.add(a, b,
                     t % 4 ? corner(c)
                           : Eigen::Vector3d(a + random(0, 1) * (b - a) + 1e-3 * size * z * random.vector()));
        }
        const auto found = coordinates(soup, depth_camera, Pose{});
        const Rays rays(soup.positions, soup.indices);
        for (std::size_t v = 0; v < soup.positions.size(); ++v) {
            const Eigen::Vector3d p = soup.positions[v].cast<double>();
            const auto at = project(depth_camera, Pose{}, p);
            if (!at || !in_frame(depth_camera, at->pixel)) {
                EXPECT_EQ(found[v], Eigen::Vector2f(-1, -1)) << "seed " << seed << " vertex " << v;
                continue;
            }
            const bool free = rays.first(Eigen::Vector3d::Zero(), p) > 1 - 0.3 / depth_camera.fy;
            ++(free ? visible : hidden);
            differ += free != (found[v].x() >= 0);
        }
    }
    EXPECT_GT(visible, 300u);
    EXPECT_GT(hidden, 300u);
    EXPECT_EQ(differ, 0u) << "of " << visible + hidden;
}

TEST_F(Depth, FrustumCullingKeepsEveryHitTriangle) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        Random random(seed);
        Soup soup;
        for (int t = 0; t < 400; ++t) {
            const double size = std::pow(10, random(-2, 1.5));
            const Eigen::Vector3d c = 9 * random.vector();
            soup.add(c + size * random.vector(), c + size * random.vector(), c + size * random.vector());
        }
        const Pose pose{random.rotation(), 3 * random.vector()};
        const auto clusters = make_clusters(soup.positions, soup.indices, 1 + seed * 7 % 50);
        std::vector<bool> kept(soup.indices.size() / 3, false), drawn = kept;
        for (const auto& source : triangles_in_frame(clusters, soup.indices, depth_camera, pose).sources)
            kept[source.triangle] = true;
        const View view{depth_camera, pose};
        for (const std::uint32_t c : clusters_in_view(make_cluster_tree(clusters), clusters, view))
            for (std::uint32_t t = 0; t < clusters[c].triangles; ++t)
                drawn[clusters[c].first_triangle + t] = true;
        const Rays rays(soup.positions, soup.indices);
        for (int i = 0; i < 300; ++i) {
            const Eigen::Vector3d ray =
                ray_of(depth_camera, pose, random(0, depth_camera.width), random(0, depth_camera.height));
            for (std::size_t t = 0; t < kept.size(); ++t)
                ASSERT_TRUE(!std::isfinite(rays.at(t, pose.center(), ray)) || (kept[t] && drawn[t]))
                    << "seed " << seed << " triangle " << t;
        }
    }
}

TEST_F(Depth, PlayerShowsTheNearestSurfaceOverANearFarRatioOfAMillion) {
    SynthSpec spec = spec_named("tiny");
    spec.photos.count = 2;
    spec.photos.samples = 1;
    copy_scene(spec, dir / "scene");
    SceneInput scene = read_scene(discover(dir / "scene"));
    const Intrinsics k = scene.photos[0].camera.intrinsics;
    scene.mesh = {};
    const auto add_square = [&](const Eigen::Vector3d& corner, const Eigen::Vector3d& u,
                                const Eigen::Vector3d& v) {
        const auto first = std::uint32_t(scene.mesh.positions.size());
        for (const Eigen::Vector3d& p : {corner, Eigen::Vector3d(corner + u), Eigen::Vector3d(corner + u + v),
                                         Eigen::Vector3d(corner + v)}) {
            scene.mesh.positions.push_back(p);
            scene.mesh.normals.emplace_back(0, 0, -1);
        }
        scene.mesh.triangles.push_back({first, first + 1, first + 2});
        scene.mesh.triangles.push_back({first, first + 2, first + 3});
    };
    for (const double side : {-1.0, 1.0})
        for (int strip = 0; strip < 7; ++strip)
            for (const double behind : {1.0, 1.0005, 1.001}) {
                const double z = side * behind * std::pow(10, strip);
                add_square(z * Eigen::Vector3d((10 + 45 * strip - k.cx) / k.fx, -0.5, 1),
                           z * Eigen::Vector3d(40 / k.fx, 0, 0), z * Eigen::Vector3d(0, 1, 0));
            }
    for (PhotoInput& photo : scene.photos) photo.camera.cam_from_world = {};
    prepare(scene, {}, dir / "a.vantage", [](const Progress&) {});
    const PackageReader package(dir / "a.vantage");
    Renderer renderer(package, {});
    const std::vector<std::uint32_t> photos{0, 1};
    const View view = view_of_photo(package.photos()[0], 1);
    const Picture picture = take_picture(renderer, view, {}, photos, 1);
    const auto shown = read_triangles(renderer.resources().targets);
    const Rays rays(package.records<Eigen::Vector3f>(package::Type::positions),
                    package.records<std::uint32_t>(package::Type::indices));
    const Eigen::Vector3d eye = view.cam_from_origin.center();
    std::size_t seen = 0, colored = 0;
    for (int y = 0; y < k.height; y += 3)
        for (int x = 0; x < k.width; x += 3) {
            const Eigen::Vector3d ray = ray_of(k, view.cam_from_origin, x + 0.5, y + 0.5);
            const double z = rays.first(eye, ray);
            const std::size_t at = std::size_t(y) * std::size_t(k.width) + std::size_t(x);
            if (!std::isfinite(z)) continue;
            ++seen;
            ASSERT_GT(shown[at], 0u) << "at " << x << "," << y << " depth " << z;
            ASSERT_NEAR(rays.at(shown[at] - 1, eye, ray), z, 1e-5 * z) << "at " << x << "," << y;
            colored += picture.rgba[4 * at + 3] == 255;
        }
    EXPECT_GT(seen, 4000u);
    EXPECT_GT(double(colored), 0.99 * double(seen));
}
