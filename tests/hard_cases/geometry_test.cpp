// Meshes that are degenerate, duplicated, broken, inside out, tiny or huge.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <functional>
#include <limits>
#include <numeric>
#include <random>

#include "base/gl/context.h"
#include "base/text/error.h"
#include "base/values/tiling.h"
#include "pipeline/formats/meshes/read_mesh.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/mesh/clusters.h"
#include "pipeline/mesh/subdivide.h"
#include "pipeline/prepare/prepare.h"
#include "pipeline/reports/check.h"
#include "pipeline/run/until_stopped.h"
#include "pipeline/stages/footprint_hull.h"
#include "pipeline/stages/surface_samples.h"
#include "player/measure/bench/finite_targets.h"
#include "player/render/picture.h"
#include "scene/agreement/read_level.h"
#include "scene/package/package_reader.h"
#include "tests/hard_cases/special_numbers.h"
#include "tests/made_scenes.h"
#include "tests/temporary_folder.h"

using namespace vantage;
using package::Type;

namespace {

class Geometry : public TemporaryFolder {
  protected:
    const gl::HeadlessContext context{gl::Debug::on};
    SceneInput scene;

    void SetUp() override {
        TemporaryFolder::SetUp();
        SynthSpec spec = spec_named("tiny");
        spec.photos.count = 2;
        spec.photos.arc = 25;
        spec.photos.samples = 1;
        spec.photos.width = 200;
        spec.photos.height = 150;
        spec.object.triangles = 1500;
        copy_scene(spec, dir / "scene");
        scene = read_scene(discover(dir / "scene"));
    }

    /// Writes a mesh, valid or not, to a PLY file.
    std::filesystem::path written(const Mesh& mesh) const {
        const std::filesystem::path file = dir / "mesh.ply";
        std::ofstream out(file, std::ios::binary);
        out << fmt::format("ply\nformat ascii 1.0\nelement vertex {}\n", mesh.positions.size());
        for (const char* name : {"double x", "double y", "double z"}) out << "property " << name << '\n';
        if (!mesh.normals.empty())
            for (const char* name : {"float nx", "float ny", "float nz"}) out << "property " << name << '\n';
        out << fmt::format("element face {}\nproperty list uchar int vertex_indices\nend_header\n",
                           mesh.triangles.size());
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            const Eigen::Vector3d& p = mesh.positions[v];
            out << fmt::format("{} {} {}", p.x(), p.y(), p.z());
            if (!mesh.normals.empty())
                out << fmt::format(" {} {} {}", mesh.normals[v].x(), mesh.normals[v].y(),
                                   mesh.normals[v].z());
            out << '\n';
        }
        for (const auto& t : mesh.triangles) out << fmt::format("3 {} {} {}\n", t[0], t[1], t[2]);
        return file;
    }

    struct Result {
        std::vector<std::string> warnings;
        std::vector<Picture> pictures;  ///< from each photo's camera, in each blend mode
        std::vector<double> seen;       ///< share of the vertices that each photo sees
        std::size_t triangles = 0;
    };
    /// Reads, prepares, checks and renders a mesh. The package must be valid and all values finite.
    Result shown(const Mesh& mesh, const std::function<void(SceneInput&)>& change = {}) {
        Result out;
        SceneInput with = scene;
        with.mesh = read_mesh(written(mesh), out.warnings);
        if (change) change(with);
        const std::filesystem::path file = dir / "a.vantage";
        PrepareSettings settings;
        settings.vertex_coordinates = true;
        prepare(with, settings, file, [](const Progress&) {});
        for (const Issue& i : check_package(file, {.deep = true})) ADD_FAILURE() << i.text;
        const PackageReader reader(file);
        expect_finite(reader);
        Renderer renderer(reader, {});
        std::vector<std::uint32_t> photos(reader.photos().size());
        std::iota(photos.begin(), photos.end(), 0u);
        for (const std::uint32_t photo : photos) {
            out.seen.push_back(reader.photos()[photo].visible_vertices);
            for (const Blend blend : {Blend::lumigraph, Blend::average, Blend::best}) {
                RenderSettings s;
                s.blend = blend;
                s.fill_holes = true;
                out.pictures.push_back(
                    take_picture(renderer, view_of_photo(reader.photos()[photo], 1), s, photos, 1));
                EXPECT_EQ(count_non_finite(renderer.targets()).all(), 0u) << "blend " << int(blend);
            }
        }
        out.triangles = std::size_t(reader.scene().triangles);
        return out;
    }

    static void expect_all_finite(std::span<const float> values, const char* what) {
        EXPECT_TRUE(std::ranges::all_of(values, [](float v) { return std::isfinite(v); })) << what;
    }
    static void expect_finite(const PackageReader& reader) {
        const package::SceneRecord& s = reader.scene();
        EXPECT_TRUE(std::isfinite(s.reference_density) && s.reference_density > 0);
        expect_all_finite(reader.records<float>(Type::positions), "positions");
        expect_all_finite(reader.records<float>(Type::normals), "normals");
        for (const auto& c : reader.records<package::ClusterRecord>(Type::clusters))
            expect_all_finite({c.center, 8}, "clusters");
        for (std::uint32_t i = 0; i < reader.photos().size(); ++i) {
            const package::PhotoRecord& p = reader.photos()[i];
            for (const double v :
                 {p.corrected_direction[0], p.corrected_direction[1], p.corrected_direction[2], p.hull_area,
                  p.seen_distance, p.z_min, p.z_max, p.visible_vertices})
                EXPECT_TRUE(std::isfinite(v)) << p.name;
            EXPECT_NEAR(Eigen::Map<const Eigen::Vector3d>(p.corrected_direction).norm(), 1, 1e-6);
            expect_all_finite(reader.records<float>(Type::coordinates, i), "coordinates");
            const auto depth = read_level(reader, p, i, Type::depth, mask_level);
            for (std::size_t t = 0; t < depth.size(); t += 4) {
                float z;
                std::memcpy(&z, &depth[t], 4);
                ASSERT_TRUE(z > 0) << "depth of " << p.name;  // infinite if nothing is seen
            }
        }
    }

    /// Expects all but a few pixels to be equal.
    static void expect_same(const std::vector<Picture>& a, const std::vector<Picture>& b) {
        ASSERT_EQ(a.size(), b.size());
        for (std::size_t i = 0; i < a.size(); ++i) {
            std::size_t differ = 0;
            for (std::size_t c = 0; c < a[i].rgba.size(); ++c)
                differ += std::abs(int(a[i].rgba[c]) - int(b[i].rgba[c])) > 6;
            EXPECT_LT(double(differ), 1e-3 * double(a[i].rgba.size())) << "picture " << i;
        }
    }

    static std::uint32_t add(Mesh& mesh, const Eigen::Vector3d& p) {
        mesh.positions.push_back(p);
        mesh.normals.emplace_back(0, 0, 1);
        return std::uint32_t(mesh.positions.size() - 1);
    }
    /// By value: the arguments may be elements of the mesh.
    static void add(Mesh& mesh, Eigen::Vector3d a, Eigen::Vector3d b, Eigen::Vector3d c) {
        const std::uint32_t i = add(mesh, a), j = add(mesh, b), k = add(mesh, c);
        mesh.triangles.push_back({i, j, k});
    }
    void expect_rejected(const Mesh& mesh, const std::string& words) {
        try {
            shown(mesh);
            ADD_FAILURE() << "was accepted, expected: " << words;
        } catch (const Error& e) {
            EXPECT_EQ(e.code(), Exit::input);
            const std::string text = e.what();
            EXPECT_NE(text.find(words), std::string::npos) << text;
            EXPECT_EQ(text.find('\n'), std::string::npos) << text;
            EXPECT_NE(text.find(".ply"), std::string::npos) << text;
        }
    }
};
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
        EXPECT_NEAR(twice.seen[i], valid.seen[i], 0.01) << "a surface does not occlude its duplicate";
}

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
    EXPECT_EQ(mesh.positions.size(), 4u) << "shared corners are one vertex";
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
                              main_box(scene.mesh));  // done here because it depends on the order of corners
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
    // Seven triangles on one edge, two fans that meet in a point, a closed and an open tetrahedron.
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
    // The square of a normal's length is the fourth power of an edge length, which overflows or underflows.
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
    EXPECT_EQ(checksum(), before) << "the same triangles, in another order";
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

namespace {

/// Corners of the convex hull, in order (Andrew's monotone chain), in double precision.
std::vector<Eigen::Vector2d> hull_of(std::vector<Eigen::Vector2d> p) {
    std::ranges::sort(
        p, [](const auto& a, const auto& b) { return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y()); });
    p.erase(std::unique(p.begin(), p.end()), p.end());
    if (p.size() < 3) return p;
    std::vector<Eigen::Vector2d> hull;
    for (int pass = 0; pass < 2; ++pass) {
        const std::size_t start = hull.size();
        for (const Eigen::Vector2d& q : p) {
            const auto turns_left = [&] {
                const Eigen::Vector2d u = hull.back() - hull[hull.size() - 2], v = q - hull.back();
                return u.x() * v.y() - u.y() * v.x() > 0;
            };
            while (hull.size() >= start + 2 && !turns_left()) hull.pop_back();
            hull.push_back(q);
        }
        hull.pop_back();
        std::ranges::reverse(p);
    }
    return hull;
}

struct Polygon {
    double area = 0;
    Eigen::Vector2d centroid = Eigen::Vector2d::Zero();
};
Polygon measured(const std::vector<Eigen::Vector2d>& corners) {
    Polygon out;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Eigen::Vector2d a = corners[i] - corners[0], b = corners[(i + 1) % corners.size()] - corners[0];
        const double part = (a.x() * b.y() - a.y() * b.x()) / 2;
        out.area += part;
        out.centroid += part * (a + b) / 3;
    }
    if (out.area > 0) out.centroid = corners[0] + out.centroid / out.area;
    return out;
}

const Intrinsics frame{400, 300, 350, 360, 190, 160};

Eigen::Vector3d through(const Eigen::Vector2d& uv) {
    return Eigen::Vector3d((uv.x() * frame.width - frame.cx) / frame.fx,
                           (uv.y() * frame.height - frame.cy) / frame.fy, 1)
        .normalized();
}

}  // namespace

TEST(FootprintHull, MatchesTheMonotoneChain) {
    std::mt19937 random(19);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int trial = 0; trial < 300; ++trial) {
        std::vector<Eigen::Vector2f> uv;
        std::vector<Eigen::Vector2d> visible;
        const int points = 3 + trial % 40, grid = trial % 3 ? 0 : 5;
        for (int i = 0; i < points; ++i) {
            Eigen::Vector2d p(unit(random), unit(random) * (trial % 7 ? 1 : 0.01));
            if (grid) p = (p * grid).array().floor() / grid;  // many collinear, many equal
            const Eigen::Vector2f q = p.cast<float>();
            uv.push_back(q);
            visible.push_back(q.cast<double>());
            if (i % 4 == 0) uv.emplace_back(-1, -1);
        }
        const Polygon truth = measured(hull_of(visible));
        const FootprintHull found = footprint_hull(uv, frame, Pose{});
        ASSERT_NEAR(found.area, truth.area, 1e-6) << "trial " << trial;
        ASSERT_TRUE(truth.area < 1e-5 || (found.direction - through(truth.centroid)).norm() < 1e-3)
            << "trial " << trial;
        ASSERT_NEAR(found.direction.norm(), 1, 1e-9);
    }
}

RC_GTEST_PROP(FootprintHull, AnyPointsMatchTheMonotoneChain, ()) {
    // On a coarse grid, so that many are collinear or equal.
    const auto grid = *rc::gen::container<std::vector<std::array<int, 2>>>(
        rc::gen::container<std::array<int, 2>>(rc::gen::inRange(0, 17)));
    std::vector<Eigen::Vector2f> uv;
    std::vector<Eigen::Vector2d> visible;
    for (const auto& [x, y] : grid) {
        uv.emplace_back(float(x) / 16, float(y) / 16);
        visible.push_back(uv.back().cast<double>());
    }
    const Polygon truth = visible.empty() ? Polygon{} : measured(hull_of(visible));
    const FootprintHull found = footprint_hull(uv, frame, Pose{});
    RC_ASSERT(std::abs(found.area - truth.area) < 1e-6);
    RC_ASSERT(std::abs(found.direction.norm() - 1) < 1e-9);
    if (truth.area > 1e-5) RC_ASSERT((found.direction - through(truth.centroid)).norm() < 1e-3);
}

TEST(FootprintHull, NoPointsOnePointOrALineHaveNoAreaButADirection) {
    const Pose pose{Eigen::AngleAxisd(0.8, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix(),
                    {1, 2, 3}};
    for (const auto& uv : {std::vector<Eigen::Vector2f>{}, std::vector<Eigen::Vector2f>(50, {-1, -1})}) {
        const FootprintHull none = footprint_hull(uv, frame, pose);
        EXPECT_EQ(none.area, 0);
        EXPECT_LT((none.direction - pose.direction()).norm(), 1e-12) << "the optical axis";
    }
    const Eigen::Vector2f a(0.2f, 0.3f);
    for (const std::size_t copies : {1u, 2u, 3u, 1000u}) {
        const FootprintHull point = footprint_hull(std::vector<Eigen::Vector2f>(copies, a), frame, Pose{});
        EXPECT_EQ(point.area, 0) << copies;
        EXPECT_LT((point.direction - through(a.cast<double>())).norm(), 1e-6) << copies;
    }
    for (const Eigen::Vector2f& along :
         {Eigen::Vector2f(0.5f, 0), {0, 0.5f}, {0.5f, 0.25f}, {0.375f, 0.5f}}) {
        std::vector<Eigen::Vector2f> line;
        for (int i = 0; i <= 16; ++i)
            line.push_back(Eigen::Vector2f(0.25f, 0.25f) + float(i * i % 17) / 16 * along);
        line.push_back(Eigen::Vector2f(0.25f, 0.25f) + along);
        const FootprintHull found = footprint_hull(line, frame, Pose{});
        EXPECT_NEAR(found.area, 0, 1e-9) << along.transpose();
        const Eigen::Vector3d from = through({0.25, 0.25}),
                              to = through((Eigen::Vector2f(0.25f, 0.25f) + along).cast<double>());
        EXPECT_LT(std::abs(found.direction.dot(from.cross(to).normalized())), 1e-6) << "on the line";
        EXPECT_GE(found.direction.dot(from), to.dot(from) - 1e-6) << "between its ends";
    }
}
