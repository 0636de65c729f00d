// Warnings about rounded coordinates far from zero and about stray vertices, without false alarms.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <random>

#include "pipeline/formats/meshes/read_mesh.h"
#include "tests/temporary_folder.h"

using namespace vantage;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

namespace {

constexpr int grid_side = 40;
const Eigen::Vector3d utm(500000, 5400000, 120);

/// A surface of side x side vertices that is 4 m wide and has random height and spacing.
Mesh surface(const Eigen::Vector3d& at, double spacing = 0.1, double jitter = 0.03) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-jitter, jitter);
    Mesh m;
    for (int y = 0; y < grid_side; ++y)
        for (int x = 0; x < grid_side; ++x)
            m.positions.push_back(at + Eigen::Vector3d(spacing * x + any(random), spacing * y + any(random),
                                                       std::sin(0.2 * x) + any(random)));
    for (std::uint32_t y = 0; y + 1 < grid_side; ++y)
        for (std::uint32_t x = 0; x + 1 < grid_side; ++x) {
            const std::uint32_t v = y * grid_side + x;
            m.triangles.push_back({v, v + 1, v + grid_side});
            m.triangles.push_back({v + 1, v + grid_side + 1, v + grid_side});
        }
    return m;
}

class CoordinateWarnings : public TemporaryFolder {
  protected:
    std::vector<std::string> read(const std::string& name) const {
        std::vector<std::string> warnings;
        read_mesh(dir / name, warnings);
        return warnings;
    }
    /// The mesh as binary PLY with coordinates of type T.
    template <class T>
    std::vector<std::string> as_ply(const Mesh& m) const {
        const std::string type = sizeof(T) == 4 ? "float" : "double";
        std::ofstream f(dir / "mesh.ply", std::ios::binary);
        f << "ply\nformat binary_little_endian 1.0\nelement vertex " << m.positions.size();
        for (const char axis : {'x', 'y', 'z'}) f << "\nproperty " << type << ' ' << axis;
        f << "\nelement face " << m.triangles.size()
          << "\nproperty list uchar uint vertex_indices\nend_header\n";
        for (const Eigen::Vector3d& p : m.positions) {
            const Eigen::Matrix<T, 3, 1> q = p.cast<T>();
            f.write(reinterpret_cast<const char*>(q.data()), sizeof q);
        }
        for (const auto& t : m.triangles) {
            f.put(3);
            f.write(reinterpret_cast<const char*>(t.data()), sizeof t);
        }
        f.close();
        return read("mesh.ply");
    }
    /// The mesh as OBJ, with a printf format for three numbers.
    std::vector<std::string> as_obj(const Mesh& m, const char* format) const {
        std::ofstream f(dir / "mesh.obj");
        for (const Eigen::Vector3d& p : m.positions) {
            char line[200];
            std::snprintf(line, sizeof line, format, p.x(), p.y(), p.z());
            f << "v " << line << '\n';
        }
        for (const auto& t : m.triangles) f << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
        f.close();
        return read("mesh.obj");
    }
};

}  // namespace

TEST_F(CoordinateWarnings, SinglePrecisionInUtmIsNamedWithItsSteps) {
    EXPECT_THAT(
        as_ply<float>(surface(utm)),
        ElementsAre(HasSubstr("mesh.ply: coordinates are rounded (x in steps of 0.0312, y in steps of "
                              "0.5; the mesh is")));
    EXPECT_THAT(as_ply<double>(surface(utm)), IsEmpty());
    EXPECT_THAT(as_ply<float>(surface({0, 0, 0})), IsEmpty());
    EXPECT_THAT(as_ply<float>(surface({300, -200, 100})), IsEmpty());
    Mesh rounded = surface(utm);
    for (Eigen::Vector3d& p : rounded.positions)
        for (double& x : p) x = double(float(x));
    EXPECT_THAT(as_ply<double>(rounded), ElementsAre(HasSubstr("coordinates are rounded")));
}

TEST_F(CoordinateWarnings, TooFewDigitsAreNamedWithTheirSteps) {
    const Mesh m = surface(utm);
    EXPECT_THAT(as_obj(m, "%.2f %.2f %.2f"),
                ElementsAre(HasSubstr("mesh.obj: coordinates are rounded (x in steps of 0.01, y in steps of "
                                      "0.01; the mesh is")));
    EXPECT_THAT(as_obj(m, "%g %g %g"), ElementsAre(HasSubstr("(x in steps of 1;")));  // all y are the same
    EXPECT_THAT(as_obj(m, "%.6f %.6f %.6f"), IsEmpty());
    EXPECT_THAT(as_obj(surface({0, 0, 0}), "%.2f %.2f %.2f"), IsEmpty());
}

TEST_F(CoordinateWarnings, TerrainOnAGridIsValid) {
    for (const double spacing : {0.25, 0.5, 1.0, 2.0})
        EXPECT_THAT(as_ply<double>(surface(utm, spacing, 0)), IsEmpty()) << spacing;
}

TEST_F(CoordinateWarnings, StraysAreNamedWithTheirDistance) {
    Mesh m = surface(utm);
    m.positions.push_back({0, 0, 0});
    m.triangles.push_back({3, 4, grid_side * grid_side});
    EXPECT_THAT(as_ply<double>(m),
                ElementsAre(HasSubstr("mesh.ply: vertex 1600 of triangle 3042 (counted from 0) at (0, 0, 0) "
                                      "lies 5.42e+06 from the rest of the mesh, which is 5.9")));
    m.positions.push_back({1e6, 0, 0});
    m.triangles.push_back({3, 4, grid_side * grid_side + 1});
    EXPECT_THAT(as_obj(m, "%.9f %.9f %.9f"), ElementsAre(HasSubstr("; 1 more vertices lie far away")));
}

TEST_F(CoordinateWarnings, StraysDoNotHideRounding) {
    Mesh m = surface(utm);
    m.positions.push_back({0, 0, 0});
    m.triangles.push_back({3, 4, grid_side * grid_side});
    EXPECT_THAT(as_ply<float>(m),
                ElementsAre(HasSubstr("vertex 1600"), HasSubstr("coordinates are rounded (x in steps of")));
}

// Real scans have a dense object in large surroundings. The surroundings are not strays.
TEST_F(CoordinateWarnings, BackgroundAreNotStrays) {
    Mesh m = surface({0, 0, 0}, 0.001, 0.0003);
    const auto n = std::uint32_t(m.positions.size());
    const Mesh ground = surface({-2000, -2000, 0}, 100);
    m.positions.insert(m.positions.end(), ground.positions.begin(), ground.positions.end());
    for (const auto& t : ground.triangles) m.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
    EXPECT_THAT(as_ply<double>(m), IsEmpty());
}
