#include "player/survey/profile.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <limits>
#include <sstream>

#include "player/survey/ray_cast.h"
#include "tests/player/survey/mesh_scene.h"

using namespace vantage;
using Eigen::Vector3d;

namespace {

const Vector3d up = Vector3d::UnitZ();

/// A surface of square cells over x and y from 0 to `size`, at the heights z(x, y), turned by R.
MeshScene relief(const Eigen::Matrix3d& R, int size, double cell,
                 const std::function<double(double, double)>& z) {
    MeshScene m;
    const auto at = [&](int i, int j) -> Vector3d {
        return R * Vector3d(i * cell, j * cell, z(i * cell, j * cell));
    };
    for (int j = 0; j < size; ++j)
        for (int i = 0; i < size; ++i) {
            m.add(at(i, j), at(i + 1, j), at(i + 1, j + 1));
            m.add(at(i, j), at(i + 1, j + 1), at(i, j + 1));
        }
    m.finish();
    return m;
}

/// A wall in the plane z = 0 with a pillar that projects by 0.25 from x = 1 to 2, a back that is not
/// parallel, something 2.5 in front of it, and nearer, the back of an object whose front is there; all before
/// it is turned by R.
MeshScene facade(const Eigen::Matrix3d& R) {
    MeshScene m;
    const auto part = [&](const Vector3d& corner, const Vector3d& u) {
        m.add_quad(R * corner, R * u, R * Vector3d(0, 1, 0));
    };
    part({0, 0, 0}, {1, 0, 0}), part({1, 0, 0}, {0, 0, 0.25}), part({1, 0, 0.25}, {1, 0, 0});
    part({2, 0, 0.25}, {0, 0, -0.25}), part({2, 0, 0}, {1, 0, 0}), part({0, 0, 2.5}, {3, 0, 0});
    m.add_quad(R * Vector3d(0.4, 0, 1), R * Vector3d(0, 1, 0), R * Vector3d(0.3, 0, 0));
    m.add_quad(R * Vector3d(0, 0, -0.05), R * Vector3d(0, 1, -0.3), R * Vector3d(3, 0, 0));
    m.finish();
    return m;
}

/// Neither vertical nor horizontal, for all normals in these tests.
Eigen::Matrix3d tilted() { return Eigen::AngleAxisd(0.8, Vector3d(1, 0.3, 0.1).normalized()).matrix(); }

SurfaceProfile profile_of(const MeshScene& m, const Vector3d& from, const Vector3d& to,
                          std::span<const SectionPlane> cuts = {}) {
    const PlacedMesh mesh{&m.scene};
    return profile_between({&mesh, 1}, cuts, {from, to}, up);
}

/// Expects the offset truth(distance) everywhere; NaN: no surface.
void expect_offsets(const SurfaceProfile& p, const std::function<double(double)>& truth) {
    ASSERT_EQ(p.reason, nullptr) << p.reason;
    ASSERT_EQ(p.offsets.size(), 401u);
    for (std::size_t i = 0; i < p.offsets.size(); ++i) {
        const double expected = truth(p.distance(i));
        ASSERT_EQ(p.offsets[i].has_value(), !std::isnan(expected)) << "at " << p.distance(i);
        if (p.offsets[i]) {
            ASSERT_NEAR(*p.offsets[i], expected, 1e-6) << "at " << p.distance(i);
        }
    }
}

}  // namespace

TEST(Profile, OfATiltedFacadeHasTheStepsOfItsPillar) {
    const Eigen::Matrix3d R = tilted();
    const MeshScene m = facade(R);
    const SurfaceProfile p = profile_of(m, R * Vector3d(0.1, 0.5, 0), R * Vector3d(2.9, 0.5, 0));
    expect_offsets(p, [](double s) { return s > 0.9 && s < 1.9 ? 0.25 : 0; });
    EXPECT_NEAR(p.length, 2.8, 1e-12);
    EXPECT_FALSE(p.heights);
    EXPECT_LT((*p.point(200) - R * Vector3d(1.5, 0.5, 0.25)).norm(), 1e-6);
}

TEST(Profile, IsThatOfTheRemainingSurface) {
    const Eigen::Matrix3d R = tilted();
    const MeshScene m = facade(R);
    const SectionPlane cut{R * up, 0.1};  // cuts the front of the pillar away
    expect_offsets(profile_of(m, R * Vector3d(0.1, 0.5, 0), R * Vector3d(2.9, 0.5, 0), std::span(&cut, 1)),
                   [](double s) { return s > 0.9 && s < 1.9 ? -0.2 : 0; });
}

TEST(Profile, OfTerrainHasHeightsOverHorizontalDistances) {
    const double cell = 0.125;
    const auto wave = [](double x) { return 0.3 * std::sin(2 * x); };
    const MeshScene m =
        relief(Eigen::Matrix3d::Identity(), 80, cell, [&](double x, double y) { return wave(x) + 0.1 * y; });
    const auto height = [&](double x, double y) {  // cells are flat
        const double i = std::floor(x / cell), share = x / cell - i;
        return (1 - share) * wave(i * cell) + share * wave((i + 1) * cell) + 0.1 * y;
    };
    const Vector3d from(0.33, 1, height(0.33, 1)), to(9.33, 9, height(9.33, 9));
    const SurfaceProfile p = profile_of(m, from, to);
    EXPECT_TRUE(p.heights);
    EXPECT_EQ(p.across, up);
    EXPECT_NEAR(p.length, std::hypot(9, 8), 1e-12);
    EXPECT_NEAR(p.rise, to.z() - from.z(), 1e-12);
    expect_offsets(p, [&](double s) {
        return height(from.x() + 9 * s / p.length, from.y() + 8 * s / p.length) - from.z();
    });
}

TEST(Profile, IsWhatRaysFromOutsideHit) {
    const MeshScene m = relief(tilted(), 30, 0.2, [](double x, double y) {  // rough
        return 0.075 * std::sin(1e4 * x + 3e4 * y);
    });
    PlacedMesh mesh{&m.scene};
    mesh.R = Eigen::AngleAxisd(0.4, Vector3d::UnitX()).matrix();
    mesh.t = {10, 20, 30};
    mesh.scale = 2;
    const auto hit_at = [&](const Vector3d& from, const Vector3d& along) {
        return first_hit(m.scene, {mesh.in_mesh(from), mesh.R.transpose() * along / mesh.scale});
    };
    const Vector3d normal = mesh.R * tilted().col(2);
    std::array<Vector3d, 2> ends{Vector3d(1, 1, 0), Vector3d(5, 3, 0)};
    for (Vector3d& end : ends) {
        const Vector3d outside = mesh.in_scene(tilted() * end) + 2 * normal;
        end = outside - hit_at(outside, -normal).value().distance * normal;
    }
    const SurfaceProfile p = profile_between({&mesh, 1}, {}, ends, up);
    EXPECT_GT(p.across.dot(normal), 0.99);
    EXPECT_NEAR(p.across.dot(ends[1] - ends[0]), 0, 1e-9);
    expect_offsets(p, [&](double s) {
        const auto hit = hit_at(p.from + s * p.along + 2 * p.across, -p.across);
        return hit ? 2 - hit->distance : std::nan("");
    });
}

TEST(Profile, OutsideIsWherePhotosAreNotWhereTrianglesFace) {
    MeshScene wall;  // of two leaves, both wound inward
    wall.add_quad({0, 0, 0}, {0, 0, 3}, {3, 0, 0});
    wall.add_quad({0, 0.2, 0}, {0, 0, 3}, {3, 0, 0});
    const Eigen::Matrix3d toward_y{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}};
    wall.finish();
    wall.add_photo({toward_y, -toward_y * Vector3d(1.5, -5, 1.5)}, 800);
    const SurfaceProfile p = profile_of(wall, {0.5, 0, 1}, {2.5, 0, 1});
    EXPECT_LT((p.across - Vector3d(0, -1, 0)).norm(), 1e-12);
    expect_offsets(p, [](double) { return 0; });
    expect_offsets(profile_of(wall, {0.5, 0.2, 1}, {2.5, 0.2, 1}), [](double) { return 0; });
}

TEST(Profile, OfACeilingShowsItsUndersideAsHeights) {
    MeshScene m;
    m.add_quad({0, 0, 3}, {0, 4, 0}, {4, 0, 0.4});
    m.add_quad({0, 0, 3.5}, {4, 0, 0.4}, {0, 4, 0});  // the floor above
    m.finish();
    const SurfaceProfile p = profile_of(m, {0.5, 2, 3.05}, {3.5, 2, 3.35});
    EXPECT_EQ(p.across, up);
    expect_offsets(p, [](double s) { return 0.1 * s; });
}

TEST(Profile, OfASlopeShowsWhatIsNearTheLine) {
    MeshScene m;
    m.add_quad({0, 0, 0}, {3, 0, 0.9}, {0, 1, 0});
    m.add_quad({0, 0, 0.8}, {3, 0, 0.9}, {0, 1, 0});
    m.finish();
    expect_offsets(profile_of(m, {0.5, 0.5, 0.15}, {2.5, 0.5, 0.75}), [](double s) { return 0.8 + 0.3 * s; });
}

TEST(Profile, GivesReasonsInsteadOfWrongValues) {
    const MeshScene m = facade(Eigen::Matrix3d::Identity());
    const Vector3d a(0.2, 0.5, 0), b(2.5, 0.5, 0);
    const auto reason = [&](const Vector3d& from, const Vector3d& to) {
        const SurfaceProfile p = profile_of(m, from, to);
        EXPECT_TRUE(p.offsets.empty());
        return std::string(p.reason ? p.reason : "none");
    };
    EXPECT_EQ(reason(a, a), "no profile: the points are equal");
    EXPECT_EQ(reason(a, Vector3d::Constant(std::nan(""))), "no profile: the points are equal");
    EXPECT_NE(reason(a, a + Vector3d(0, 0, 1)).find("does not run along"), std::string::npos);
    EXPECT_NE(reason({10, 10, 5}, {12, 10, 5}).find("no surface"), std::string::npos);
    EXPECT_NE(reason(a, Vector3d::Constant(std::numeric_limits<double>::infinity())), "none");
    EXPECT_NE(reason(a, Vector3d::Constant(1e300)), "none");
    const SurfaceProfile nothing = profile_between({}, {}, {a, b}, up);
    EXPECT_STREQ(nothing.reason, "no profile: no surface along the line");
    const PlanScene empty;
    const PlacedMesh mesh{&empty};
    EXPECT_STREQ(profile_between({&mesh, 1}, {}, {a, b}, up).reason, nothing.reason);
    EXPECT_EQ(profile_of(m, a, b).reason, nullptr);
}

TEST(Profile, TableHasInputCoordinatesAndTheDisplayedUnit) {
    const MeshScene m = facade(Eigen::Matrix3d::Identity());
    const SurfaceProfile p = profile_of(m, {0.5, 0.5, 0}, {4.5, 0.5, 0});  // beyond the wall
    std::istringstream table(profile_csv(p, {2, Unit::m, Unit::cm}, {500000, 5400000, 100}));
    std::vector<std::string> lines;
    for (std::string line; std::getline(table, line);) lines.push_back(line);
    ASSERT_EQ(lines.size(), 402u);
    EXPECT_EQ(lines[0], "distance,offset,unit,x,y,z");
    EXPECT_EQ(lines[1], "0,0,cm,500000.5,5400000.5,100");
    EXPECT_EQ(lines[101], "200,50,cm,500001.5,5400000.5,100.25");
    EXPECT_EQ(lines[401], "800,,cm,,,");
}
