#include "player/survey/section.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <sstream>
#include <tuple>

#include "tests/player/survey/mesh_scene.h"

using namespace vantage;
using Eigen::Vector3d;

namespace {

/// The surface of a box around the origin.
MeshScene box(const Vector3d& half) {
    MeshScene m;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            Vector3d at = Vector3d::Zero(), u = at, v = at;
            at[axis] = side * half[axis];
            u[(axis + 1) % 3] = half[(axis + 1) % 3];
            v[(axis + 2) % 3] = half[(axis + 2) % 3];
            m.add(at - u - v, at + u - v, at + u + v);
            m.add(at - u - v, at + u + v, at - u + v);
        }
    m.finish();
    return m;
}

/// The total length of all lines.
double length_of(const std::vector<SectionLine>& lines) {
    double sum = 0;
    for (const auto& [a, b] : lines) sum += (b - a).norm();
    return sum;
}

/// Whether each end of a line is also the end of another line.
bool is_closed(const std::vector<SectionLine>& lines) {
    std::map<std::tuple<long, long, long>, int> ends;
    for (const SectionLine& line : lines)
        for (const Vector3d& p : line)
            ++ends[{std::lround(p.x() * 1e6), std::lround(p.y() * 1e6), std::lround(p.z() * 1e6)}];
    for (const auto& [at, count] : ends)
        if (count % 2) return false;
    return true;
}

}  // namespace

TEST(Section, OfABoxIsItsOutline) {
    const MeshScene m = box({2, 3, 1});
    const PlacedMesh mesh{&m.scene};
    for (const double at : {-0.7, 0.0, 0.999}) {
        const auto lines = section_lines({&mesh, 1}, std::array{SectionPlane{Vector3d::UnitZ(), at}});
        EXPECT_NEAR(length_of(lines), 20, 1e-9);
        EXPECT_TRUE(is_closed(lines));
        for (const SectionLine& line : lines)
            for (const Vector3d& p : line) EXPECT_NEAR(p.z(), at, 1e-12);
    }
    EXPECT_TRUE(section_lines({&mesh, 1}, std::array{SectionPlane{Vector3d::UnitZ(), 1.001}}).empty());
    EXPECT_TRUE(section_lines({&mesh, 1}, std::array{SectionPlane{Vector3d::UnitZ(), std::nan("")}}).empty());
}

TEST(Section, ThroughCornersAndEdgesHasNoGap) {
    const MeshScene m = box({1, 1, 1});
    const PlacedMesh mesh{&m.scene};
    // Planes along diagonals of the sides, and through three corners.
    for (const Vector3d& normal : {Vector3d(1, 1, 0), Vector3d(1, -1, 0), Vector3d(1, 1, 1)})
        for (const double offset : {0.0, 1.0 / normal.norm()}) {
            const auto lines =
                section_lines({&mesh, 1}, std::array{SectionPlane{normal.normalized(), offset}});
            EXPECT_FALSE(lines.empty());
            EXPECT_TRUE(is_closed(lines)) << normal.transpose() << ", " << offset;
        }
}

TEST(Section, LinesOfABoxEndAtItsEdges) {
    const MeshScene m = box({1, 1, 1});
    const PlacedMesh mesh{&m.scene};
    std::vector<SectionPlane> planes;
    for (const int axis : {0, 1, 2})
        for (const double side : {-1.0, 1.0})
            planes.push_back({side * Vector3d::Unit(axis), axis == 2 ? 5 : 0.5});
    // Four planes cut a square out of the top and the bottom.
    const auto lines = section_lines({&mesh, 1}, planes);
    EXPECT_NEAR(length_of(lines), 8, 1e-9);
    EXPECT_TRUE(is_closed(lines));
    for (const SectionLine& line : lines)
        for (const Vector3d& p : line) EXPECT_NEAR(p.head<2>().cwiseAbs().maxCoeff(), 0.5, 1e-12);
    planes[0].offset = planes[1].offset = -0.1;  // inside out
    EXPECT_TRUE(section_lines({&mesh, 1}, planes).empty());
}

TEST(Section, ExtentIsThatOfTheVertices) {
    const MeshScene m = box({2, 3, 1});
    EXPECT_EQ(extent_along(m.scene, Vector3d::UnitY()), (std::array{-3.0, 3.0}));
    const auto [low, high] = extent_along(m.scene, Vector3d(1, 1, 0).normalized());
    EXPECT_NEAR(low, -5 / std::sqrt(2), 1e-12);
    EXPECT_NEAR(high, 5 / std::sqrt(2), 1e-12);
    EXPECT_EQ(extent_along({}, Vector3d::UnitX()), (std::array{0.0, 0.0}));
}

TEST(Section, FollowsMeshesThatArePlaced) {
    const MeshScene m = box({1, 1, 1});
    PlacedMesh mesh{&m.scene};
    mesh.R = Eigen::AngleAxisd(0.3, Vector3d::UnitZ()).toRotationMatrix();
    mesh.t = {10, 20, 30};
    mesh.scale = 2;
    const auto lines = section_lines({&mesh, 1}, std::array{SectionPlane{Vector3d::UnitZ(), 30.5}});
    EXPECT_NEAR(length_of(lines), 16, 1e-6);
    for (const SectionLine& line : lines) EXPECT_NEAR(line[0].z(), 30.5, 1e-9);
    EXPECT_TRUE(section_lines({&mesh, 1}, std::array{SectionPlane{Vector3d::UnitZ(), 0}}).empty());
}

TEST(Section, DrawingHasTheInputsCoordinatesToTheMillimeter) {
    const MeshScene m = box({1, 1, 1});
    const PlacedMesh mesh{&m.scene};
    const auto lines = section_lines({&mesh, 1}, std::array{SectionPlane{Vector3d::UnitZ(), 0.25}});
    std::istringstream dxf(section_dxf(lines, {500000.125, 5400000.5, 100}));
    std::string code, value;
    std::size_t drawn = 0;
    double highest = 0;
    while (std::getline(dxf, code) && std::getline(dxf, value)) {
        drawn += code == "0" && value == "LINE";
        if (code == "20") highest = std::max(highest, std::stod(value));
        if (code == "30") {
            EXPECT_NEAR(std::stod(value), 100.25, 1e-9);
        }
    }
    EXPECT_EQ(value, "EOF");
    EXPECT_EQ(drawn, lines.size());
    EXPECT_NEAR(highest, 5400001.5, 1e-3);
}

TEST(Section, RaysEndAtThePlane) {
    const std::array plane{SectionPlane{Vector3d::UnitX(), 2}};
    const RayRange toward = behind(plane, {{0, 0, 0}, {1, 0, 0}}),
                   from = behind(plane, {{5, 0, 0}, {-1, 0, 0}}),
                   never = behind(plane, {{5, 0, 0}, {1, 0, 0}}),
                   along = behind(plane, {{5, 0, 0}, {0, 1, 0}}),
                   kept = behind(plane, {{1, 0, 0}, {0, 1, 0}});
    EXPECT_DOUBLE_EQ(toward.farthest, 2);
    EXPECT_DOUBLE_EQ(from.nearest, 3);
    EXPECT_LT(never.farthest, never.nearest);
    EXPECT_LT(along.farthest, along.nearest);
    EXPECT_TRUE(std::isinf(kept.farthest));
}
