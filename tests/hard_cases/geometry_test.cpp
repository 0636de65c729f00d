// Tests degenerate, duplicated, invalid, inverted, tiny and huge meshes.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <fstream>
#include <limits>
#include <random>

#include "pipeline/formats/meshes/read_mesh.h"
#include "pipeline/mesh/clusters.h"
#include "pipeline/mesh/subdivide.h"
#include "pipeline/stages/surface_samples.h"
#include "player/render/picture.h"
#include "tests/hard_cases/shown_mesh.h"
#include "tests/hard_cases/special_numbers.h"

using namespace vantage;
using package::Type;

namespace {

class GeometryAtLength : public Geometry {};

}  // namespace

TEST_F(Geometry, ZeroAreaTrianglesChangeNothing) {
    const Result valid = shown(scene.mesh);
    Mesh mesh = scene.mesh;
    const Eigen::Vector3d a = mesh.positions[0], b = mesh.positions[1];
    add(mesh, a, a, a);
    add(mesh, a, b, a);
    add(mesh, a, b, (a + b) / 2);
    add(mesh, a, a + 3 * (b - a), a - 2 * (b - a));
    for (int i = 0; i < 300; ++i) add(mesh, b, b, b);
    mesh.triangles.push_back({3, 3, 4});
    mesh.triangles.push_back({5, 5, 5});
    const Result with = shown(mesh);
    expect_same(valid.pictures, with.pictures);
    ASSERT_EQ(with.warnings.size(), 1u);
    EXPECT_NE(with.warnings[0].find("2 invalid triangles"), std::string::npos) << with.warnings[0];
}

TEST_F(Geometry, DuplicateTrianglesChangeNothing) {
    const Result valid = shown(scene.mesh);
    Mesh same_corners = scene.mesh, other_corners = scene.mesh;
    const auto vertices = std::uint32_t(scene.mesh.positions.size());
    for (const Eigen::Vector3d& p : scene.mesh.positions) other_corners.positions.push_back(p);
    for (const Eigen::Vector3f& n : scene.mesh.normals) other_corners.normals.push_back(n);
    for (const auto& t : scene.mesh.triangles) {
        same_corners.triangles.push_back({t[1], t[2], t[0]});
        other_corners.triangles.push_back({t[0] + vertices, t[1] + vertices, t[2] + vertices});
    }
    expect_same(valid.pictures, shown(same_corners).pictures);
    const Result twice = shown(other_corners);
    expect_same(valid.pictures, twice.pictures);
    for (std::size_t i = 0; i < twice.seen.size(); ++i)
        EXPECT_NEAR(twice.seen[i], valid.seen[i], 0.01) << "a surface should not occlude its duplicate";
}

// Unused vertices would move the origin and the near plane.
TEST_F(Geometry, UnusedVerticesChangeNothing) {
    const Result valid = shown(scene.mesh);
    Mesh mesh = scene.mesh;
    for (const double far : {1e3, -1e6, 1e12, 1e200}) add(mesh, {far, -far, far});
    add(mesh, {not_a_number, 0, 0});
    add(mesh, {infinite, -infinite, 0});
    expect_same(valid.pictures, shown(mesh).pictures);
}

TEST_F(Geometry, TrianglesWithNonFiniteVerticesAreDropped) {
    const Result valid = shown(scene.mesh);
    Mesh mesh = scene.mesh;
    for (const double bad : {not_a_number, infinite, -infinite, 1e300, -1e30})
        for (int axis = 0; axis < 3; ++axis) {
            Eigen::Vector3d p = mesh.positions[0];
            p[axis] = bad;
            add(mesh, mesh.positions[0], p, mesh.positions[2]);
        }
    const Result with = shown(mesh);
    expect_same(valid.pictures, with.pictures);
    ASSERT_EQ(with.warnings.size(), 1u);
    EXPECT_NE(with.warnings[0].find("15 invalid triangles"), std::string::npos) << with.warnings[0];
}

// Corners are sorted by position to weld them; a NaN would break their order, and valid corners would be
// lost.
TEST_F(Geometry, NanCornersInStlDoNotAffectOtherTriangles) {
    std::ofstream out(dir / "mesh.stl");
    out << "solid\n";
    const auto facet = [&](const char* a, const char* b, const char* c) {
        out << "facet normal 0 0 1\nouter loop\n";
        for (const char* corner : {a, b, c}) out << "vertex " << corner << '\n';
        out << "endloop\nendfacet\n";
    };
    facet("nan 2 3", "nan 0 0", "nan 1 0");
    facet("1 2 3", "0 0 0", "0 1 0");
    facet("1 2 3", "0 1 0", "5 2 3");
    out << "endsolid\n";
    out.close();
    std::vector<std::string> warnings;
    const Mesh mesh = read_mesh(dir / "mesh.stl", warnings);
    EXPECT_EQ(mesh.triangles.size(), 2u);
    EXPECT_EQ(mesh.positions.size(), 4u) << "shared corners should be merged";
}

TEST_F(Geometry, InvalidNormalsAreRecomputed) {
    Mesh mesh = scene.mesh;
    const float bad[] = {0, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                         1e30f, 1e-30f};
    for (std::size_t v = 0; v < mesh.normals.size(); ++v) {
        const float times = bad[v % 5];
        mesh.normals[v] =
            v % 5 < 3 ? Eigen::Vector3f::Constant(times) : Eigen::Vector3f(times * mesh.normals[v]);
    }
    std::vector<std::string> warnings;
    const Mesh read = read_mesh(written(mesh), warnings);
    for (std::size_t v = 0; v < read.normals.size(); ++v) {
        ASSERT_NEAR(read.normals[v].norm(), 1, 1e-5) << "vertex " << v;
        ASSERT_TRUE(v % 5 != 3 || read.normals[v].dot(scene.mesh.normals[v]) > 0.999f) << "vertex " << v;
    }
    expect_same(shown(scene.mesh).pictures, shown(mesh).pictures);
}

TEST_F(GeometryAtLength, VisibilityDoesNotDependOnWindingOrNormals) {
    subdivide_large_triangles(scene.mesh,
                              main_box(scene.mesh));  // done here, since it depends on the order of corners
    const Result valid = shown(scene.mesh);
    Mesh inside_out = scene.mesh, mixed = scene.mesh, normals_only = scene.mesh;
    std::mt19937 random(11);
    for (auto& t : inside_out.triangles) std::swap(t[0], t[1]);
    for (auto& t : mixed.triangles)
        if (random() % 2) std::swap(t[0], t[1]);
    for (Eigen::Vector3f& n : inside_out.normals) n = -n;
    for (Eigen::Vector3f& n : normals_only.normals) n = -n;
    for (const Mesh& mesh : {inside_out, mixed, normals_only}) {
        const Result with = shown(mesh);
        EXPECT_EQ(with.seen, valid.seen);
        for (std::size_t i = 0; i < valid.pictures.size(); ++i) {
            std::size_t holes = 0;
            for (std::size_t c = 3; c < valid.pictures[i].rgba.size(); c += 4)
                holes += valid.pictures[i].rgba[c] != with.pictures[i].rgba[c];
            EXPECT_EQ(holes, 0u) << "picture " << i;
        }
        // The lumigraph does not use normals.
        expect_same({valid.pictures[0], valid.pictures[3]}, {with.pictures[0], with.pictures[3]});
    }
}

TEST_F(Geometry, NonManifoldOpenAndClosedSurfacesAreShown) {
    Mesh mesh;
    // Seven triangles that share one edge, two fans that meet at a point, and a closed and an open
    // tetrahedron.
    const Eigen::Vector3d low(-1, -3, 1), high(-1, -3, 4);
    const std::uint32_t i = add(mesh, low), j = add(mesh, high);
    for (int leaf = 0; leaf < 7; ++leaf) {
        const double turn = 0.9 * leaf;
        mesh.triangles.push_back({i, j, add(mesh, {-1 + 2 * std::cos(turn), -3 + 2 * std::sin(turn), 2.5})});
    }
    const std::uint32_t apex = add(mesh, {1, -3, 2});
    for (const double side : {-1.0, 1.0})
        mesh.triangles.push_back({apex, add(mesh, {1.5, -3, 2 + side}), add(mesh, {2, -3.3, 2 + side})});
    for (const std::size_t faces : {4u, 3u}) {
        const Eigen::Vector3d at(double(faces), -2, 1);
        const std::uint32_t v[] = {add(mesh, at), add(mesh, at + Eigen::Vector3d(1, 0, 0)),
                                   add(mesh, at + Eigen::Vector3d(0, 1, 0)),
                                   add(mesh, at + Eigen::Vector3d(0, 0, 1))};
        const std::array<std::uint32_t, 3> all[] = {
            {v[0], v[1], v[3]}, {v[1], v[2], v[3]}, {v[2], v[0], v[3]}, {v[0], v[2], v[1]}};
        mesh.triangles.insert(mesh.triangles.end(), all, all + faces);
    }
    const Result with = shown(mesh);
    EXPECT_TRUE(with.warnings.empty());
    EXPECT_GT(with.seen[0], 0.3);
}

TEST_F(Geometry, OneTriangleIsShownAndNoneIsRejected) {
    Mesh one;
    add(one, {-2, -1, 0.5}, {2, -1, 0.5}, {0, -1, 5});
    const Result with = shown(one);
    EXPECT_GE(with.triangles, 1u);
    EXPECT_EQ(with.seen[0], 1);
    const Picture& p = with.pictures[0];
    EXPECT_EQ(int(p.rgba[4 * std::size_t(p.height / 2 * p.width + p.width / 2) + 3]), 255);
    Mesh none = one;
    none.triangles.clear();
    expect_rejected(none, "has points only, expected a mesh with triangles");
    Mesh broken = one;
    broken.triangles = {{0, 0, 1}, {0, 1, 7}};
    expect_rejected(broken, "has points only, expected a mesh with triangles");
    expect_rejected({}, "has no vertices");
}

TEST_F(Geometry, CollinearOrCoincidentPointsShowNothing) {
    for (const double along : {0.0, 1.0}) {
        Mesh mesh;
        for (int i = 0; i < 40; ++i) {
            const Eigen::Vector3d p(0.3, -1, 2);
            const auto at = [&](int n) {
                return Eigen::Vector3d(p + along * 0.02 * n * Eigen::Vector3d(1, 0, 0.5));
            };
            add(mesh, at(i), at(3 * i % 10), at(7 * i % 35));
        }
        const Result with = shown(mesh);
        EXPECT_EQ(with.seen[0], 1) << "nothing occludes it";
        for (const Picture& p : with.pictures)
            for (std::size_t c = 3; c < p.rgba.size(); c += 4) ASSERT_EQ(p.rgba[c], p.rgba[3]);
    }
}

TEST_F(Geometry, PhotosThatSeeNothingAreValid) {
    for (const std::size_t blind : {1u, 2u}) {
        const Result with = shown(scene.mesh, [&](SceneInput& s) {
            for (std::size_t i = 0; i < blind; ++i) {
                Pose& pose = s.photos[i].camera.cam_from_world;
                const Eigen::Vector3d behind = pose.center() - 100 * pose.direction();
                pose.R = (Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitY()) * pose.R).eval();
                pose.t = -pose.R * behind;
            }
        });
        EXPECT_EQ(with.seen[0], 0);
        EXPECT_EQ(with.seen[1] > 0.1, blind < 2);
    }
}

TEST_F(Geometry, ClustersAreFiniteAtAllScales) {
    // The squared length of a normal grows with the fourth power of the edge length, so it overflows or
    // underflows.
    std::vector<Eigen::Vector3f> unit;
    std::vector<std::uint32_t> indices;
    for (const Eigen::Vector3d& p : scene.mesh.positions) unit.push_back(p.cast<float>());
    for (const auto& t : scene.mesh.triangles) indices.insert(indices.end(), t.begin(), t.end());
    for (const float scale : {1e-17f, 1e-9f, 1e-4f, 1e4f, 1e9f, 1e16f}) {
        std::vector<Eigen::Vector3f> positions = unit;
        for (Eigen::Vector3f& p : positions) p *= scale;
        std::vector<std::uint32_t> order = indices;
        for (const package::ClusterRecord& c : make_clusters(positions, order, 64)) {
            expect_all_finite({c.center, 8}, "cluster");
            const Eigen::Vector3f axis(c.cone_axis), center(c.center);
            ASSERT_TRUE(c.cone_cutoff >= 1 || std::abs(axis.norm() - 1) < 0.02) << scale;
            for (std::uint32_t i = 3 * c.first_triangle; i < 3 * (c.first_triangle + c.triangles); ++i)
                ASSERT_LE((positions[order[i]] - center).stableNorm(), c.radius) << scale;
        }
    }
}

TEST_F(Geometry, SurfaceDiscsAreTheSameAtAllScales) {
    std::vector<Eigen::Vector3f> unit;
    std::vector<std::uint32_t> indices;
    for (const Eigen::Vector3d& p : scene.mesh.positions) unit.push_back(p.cast<float>());
    for (const auto& t : scene.mesh.triangles) indices.insert(indices.end(), t.begin(), t.end());
    const auto truth = surface_disc_set(unit, indices, 30);
    for (const int power : {-40, -13, 13, 40}) {
        const float scale = std::ldexp(1.0f, power);
        std::vector<Eigen::Vector3f> positions = unit;
        for (Eigen::Vector3f& p : positions) p *= scale;
        const auto discs = surface_disc_set(positions, indices, 30 / double(scale));
        ASSERT_EQ(discs.size(), truth.size());
        for (std::size_t d = 0; d < discs.size(); ++d) {
            ASSERT_EQ(discs[d].center, scale * truth[d].center) << "2^" << power << " disc " << d;
            ASSERT_NEAR(discs[d].normal.norm(), 1, 1e-5) << "2^" << power << " disc " << d;
        }
    }
}

TEST_F(GeometryAtLength, TenMillionTrianglesAreAllClustered) {
    // A wavy grid of ten million triangles.
    constexpr std::uint32_t side = 2237;
    std::vector<Eigen::Vector3f> positions;
    std::vector<std::uint32_t> indices;
    positions.reserve(std::size_t(side) * side);
    indices.reserve(6 * std::size_t(side - 1) * (side - 1));
    for (std::uint32_t y = 0; y < side; ++y)
        for (std::uint32_t x = 0; x < side; ++x)
            positions.emplace_back(float(x), float(y),
                                   40 * std::sin(0.01f * float(x)) * std::cos(0.013f * float(y)));
    for (std::uint32_t y = 0; y + 1 < side; ++y)
        for (std::uint32_t x = 0; x + 1 < side; ++x) {
            const std::uint32_t a = y * side + x;
            for (const std::uint32_t v : {a, a + 1, a + side + 1, a, a + side + 1, a + side})
                indices.push_back(v);
        }
    const std::size_t triangles = indices.size() / 3;
    EXPECT_GE(triangles, 9'990'000u);
    const auto checksum = [&] {
        std::uint64_t sum = 0;
        for (std::size_t t = 0; t < triangles; ++t)
            sum += (std::uint64_t(indices[3 * t]) + indices[3 * t + 1] + indices[3 * t + 2]) *
                   0x9e3779b97f4a7c15u;
        return sum;
    };
    const std::uint64_t before = checksum();
    const auto clusters = make_clusters(positions, indices, 256);
    EXPECT_EQ(checksum(), before) << "the triangles should be the same, in a different order";
    std::uint64_t next = 0;
    for (const package::ClusterRecord& c : clusters) {
        ASSERT_EQ(c.first_triangle, next);
        ASSERT_TRUE(c.triangles > 0 && c.triangles <= 256);
        next += c.triangles;
        const Eigen::Vector3f center(c.center);
        for (std::uint32_t i = 3 * c.first_triangle; i < 3 * next; i += 97)
            ASSERT_LE((positions[indices[i]] - center).norm(), c.radius);
        ASSERT_LT(c.radius, 160) << "a tenth of the scene";
    }
    EXPECT_EQ(next, triangles);
}
