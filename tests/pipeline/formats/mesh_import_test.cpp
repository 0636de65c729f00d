// Valid and invalid meshes from other programs.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/text/error.h"
#include "pipeline/formats/meshes/read_mesh.h"
#include "pipeline/input/discover.h"
#include "tests/pipeline/formats/imported_files.h"

using namespace vantage;
namespace fs = std::filesystem;

namespace {

const char* const cube_off =
    "OFF\n8 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
    "4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";

}  // namespace

TEST_F(Import, QuadsBecomeTrianglesWithOutwardNormals) {
    put("cube.off", cube_off);
    std::vector<std::string> warnings;
    const Mesh cube = read_mesh(dir / "cube.off", warnings);
    EXPECT_EQ(cube.positions.size(), 8u);
    EXPECT_EQ(cube.triangles.size(), 12u);
    for (std::size_t v = 0; v < 8; ++v) {
        EXPECT_NEAR(cube.normals[v].norm(), 1, 1e-6);
        EXPECT_GT(cube.normals[v].dot((cube.positions[v] - Eigen::Vector3d::Constant(0.5)).cast<float>()),
                  0.5f);
    }
    EXPECT_TRUE(warnings.empty());
}

TEST_F(Import, KeepsNonManifoldFacesAndCountsBrokenOnes) {
    put("fan.off", "OFF\n5 4 0\n0 0 0\n0 0 1\n1 0 0\n0 1 0\n-1 0 0\n3 0 1 2\n3 0 1 3\n3 0 1 4\n3 0 0 1\n");
    std::vector<std::string> warnings;
    EXPECT_EQ(read_mesh(dir / "fan.off", warnings).triangles.size(), 3u);
    EXPECT_EQ(warnings.size(), 1u);
}

TEST_F(Import, MissingPartsAreReported) {
    try {
        discover(dir);
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), Exit::input);
        EXPECT_NE(std::string(e.what()).find("mesh"), std::string::npos);
    }
}

namespace {

const char* const survey_ply =
    "ply\nformat ascii 1.0\ncomment far from the origin\nelement vertex 3\nproperty double x\nproperty "
    "double y\n"
    "property double z\nproperty float intensity\nproperty uchar red\nproperty uchar green\nproperty uchar "
    "blue\n"
    "property uchar alpha\nproperty short label\nelement face 1\nproperty list uchar int "
    "vertex_indices\nend_header\n"
    "500000.125 5000000.0625 100 0.5 255 0 0 128 7\n500001.125 5000000.0625 100 0.25 0 255 0 255 8\n"
    "500000.125 5000001.0625 100 0.125 0 0 255 255 -9\n3 0 1 2\n";

/// The mesh of survey_ply as binary PLY, in big-endian byte order if `big` is set.
std::string survey_binary(bool big) {
    std::string s = survey_ply;
    s.replace(s.find("ascii"), 5, big ? "binary_big_endian" : "binary_little_endian");
    s.resize(s.find("end_header\n") + 11);
    const auto add = [&](auto v) {
        char bytes[sizeof v];
        std::memcpy(bytes, &v, sizeof v);
        if (big) std::reverse(bytes, bytes + sizeof v);
        s.append(bytes, sizeof v);
    };
    const double xyz[3][3] = {
        {500000.125, 5000000.0625, 100}, {500001.125, 5000000.0625, 100}, {500000.125, 5000001.0625, 100}};
    const std::uint8_t colors[3][4] = {{255, 0, 0, 128}, {0, 255, 0, 255}, {0, 0, 255, 255}};
    const std::int16_t labels[3] = {7, 8, -9};
    for (int v = 0; v < 3; ++v) {
        for (const double c : xyz[v]) add(c);
        add(0.5f / float(1 << v));
        for (const std::uint8_t c : colors[v]) add(c);
        add(labels[v]);
    }
    add(std::uint8_t(3));
    for (const std::int32_t i : {0, 1, 2}) add(i);
    return s;
}

}  // namespace

TEST_F(Import, PlyKeepsDoublesColorsAlphaAndScalars) {
    put("text.ply", survey_ply);
    put("little.ply", survey_binary(false));
    put("big.ply", survey_binary(true));
    for (const char* name : {"text.ply", "little.ply", "big.ply"}) {
        std::vector<std::string> warnings;
        const Mesh m = read_mesh(dir / name, warnings);
        ASSERT_EQ(m.positions.size(), 3u) << name;
        EXPECT_EQ(m.positions[2], Eigen::Vector3d(500000.125, 5000001.0625, 100)) << name;
        EXPECT_EQ(m.colors[0], (std::array<std::uint8_t, 4>{255, 0, 0, 128})) << name;
        ASSERT_EQ(m.scalars.size(), 2u) << name;
        EXPECT_EQ(m.scalars[0].name, "intensity");
        EXPECT_EQ(m.scalars[1].values, (std::vector<float>{7, 8, -9}));
        EXPECT_EQ(m.triangles.size(), 1u);
        EXPECT_NEAR(double(m.normals[0].z()), 1, 1e-6);
        EXPECT_FALSE(m.points_only());
    }
}

TEST_F(Import, TruncatedPlyOrImpossibleCountsAreRejected) {
    const std::string whole = survey_binary(false);
    std::vector<std::string> warnings;
    for (std::size_t n = 0; n < whole.size(); ++n) {
        put("cut.ply", whole.substr(0, n));
        EXPECT_THROW(read_mesh(dir / "cut.ply", warnings), Error) << n;
    }
    std::string many = whole;
    many.replace(many.find("vertex 3"), 8, "vertex 999999999999999");
    put("many.ply", many);
    EXPECT_THROW(read_mesh(dir / "many.ply", warnings), Error);
}

TEST_F(Import, PlyWithTwoElementsOfVerticesIsRejected) {
    // The first element has normals, the second has more vertices.
    put("two.ply",
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
        "property float nx\nproperty float ny\nproperty float nz\nelement vertex 3\nproperty float x\n"
        "property float y\nproperty float z\nend_header\n0 0 0 0 0 1\n0 0 0\n1 0 0\n0 1 0\n");
    std::vector<std::string> warnings;
    try {
        read_mesh(dir / "two.ply", warnings);
        FAIL() << "accepted";
    } catch (const Error& e) {
        EXPECT_EQ(e.what(), (dir / "two.ply").string() + ": expected one element vertex, found two");
    }
}

TEST_F(Import, PlyPointsStripsAndBrokenFaces) {
    std::vector<std::string> warnings;
    const std::string vertices = "property float x\nproperty float y\nproperty float z\n";
    put("points.ply",
        "ply\nformat ascii 1.0\nelement vertex 2\n" + vertices + "end_header\n0 0 0\n1 1 nan\n");
    const Mesh points = read_mesh(dir / "points.ply", warnings);
    EXPECT_TRUE(points.points_only());
    ASSERT_EQ(points.positions.size(), 1u) << "non-finite points are dropped";
    put("strip.ply", "ply\nformat ascii 1.0\nelement vertex 5\n" + vertices +
                         "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
                         "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n9 0 1 2 3 4 -1 0 1 7\n");
    const Mesh strip = read_mesh(dir / "strip.ply", warnings);
    ASSERT_EQ(strip.triangles.size(), 3u);
    for (const auto& t : strip.triangles) {
        const Eigen::Vector3d &a = strip.positions[t[0]], &b = strip.positions[t[1]],
                              &c = strip.positions[t[2]];
        EXPECT_GT((b - a).cross(c - a).z(), 0) << "consistent winding";
    }
    ASSERT_EQ(warnings.size(), 2u);
    EXPECT_NE(warnings[0].find("1 invalid point"), std::string::npos);
    EXPECT_NE(warnings[1].find("1 invalid triangle"), std::string::npos);
}

TEST_F(Import, AlphaHasARangeOfItsOwn) {
    const auto alpha = [&](const char* name, const std::string& text) {
        put(name, text);
        std::vector<std::string> warnings;
        return int(read_mesh(dir / name, warnings).colors.at(0)[3]);
    };
    const std::string real = replaced(survey_ply, "uchar alpha", "float alpha");
    EXPECT_EQ(alpha("a.ply", replaced(replaced(replaced(real, "0 0 128", "0 0 0.5"), "0 255 8", "0 1 8"),
                                      "255 255 -9", "255 1 -9")),
              128);
    EXPECT_EQ(alpha("a.ply", real), 128) << "real numbers up to 255";
    const std::string diffuse =
        replaced(replaced(replaced(survey_ply, "red", "diffuse_red"), "green", "diffuse_green"), "blue",
                 "diffuse_blue");
    EXPECT_EQ(alpha("a.ply", diffuse), 128);
    const std::string faces = "\n3 0 1 2\n";
    EXPECT_EQ(alpha("a.off", "COFF\n3 1 0\n0 0 0 9 9 9 128\n1 0 0 9 9 9 255\n0 1 0 9 9 9 255" + faces), 128);
    EXPECT_EQ(alpha("a.off", "COFF\n3 1 0\n0 0 0 9 9 9 0.5\n1 0 0 9 9 9 1\n0 1 0 9 9 9 1" + faces), 128);
    EXPECT_EQ(alpha("a.off", "COFF\n3 1 0\n0 0 0 9 9 9 128\n1 0 0 9 9 9\n0 1 0 9 9 9" + faces), 255);
}

TEST_F(Import, PlyAlphaOfFacesIsSaid) {
    std::string ply = replaced(survey_ply, "vertex_indices\n", "vertex_indices\nproperty uchar alpha\n");
    std::vector<std::string> warnings;
    put("mesh.ply", replaced(ply, "3 0 1 2", "3 0 1 2 255"));
    EXPECT_EQ(read_mesh(dir / "mesh.ply", warnings).triangles.size(), 1u);
    EXPECT_TRUE(warnings.empty());
    put("mesh.ply", replaced(ply, "3 0 1 2", "3 0 1 2 80"));
    EXPECT_EQ(read_mesh(dir / "mesh.ply", warnings).triangles.size(), 1u);
    EXPECT_EQ(warnings,
              std::vector<std::string>{"mesh.ply: alpha of faces is not read; expected alpha of vertices"});
}

TEST_F(Import, ObjVerticesWithoutColorsAreWhite) {
    put("mesh.obj", "v 0 0 0\nv 1 0 0 128 64 255\nv 0 1 0\nf 1 2 3\n");
    std::vector<std::string> warnings;
    const std::array<std::uint8_t, 4> white{255, 255, 255, 255}, violet{128, 64, 255, 255};
    EXPECT_EQ(read_mesh(dir / "mesh.obj", warnings).colors, (std::vector{white, violet, white}));
}

TEST_F(Import, FacesMayPrecedeVertices) {
    std::vector<std::string> warnings;
    put("mesh.obj", "f 1//1 2//1 3//1\nf 1 2 4\nv 0 0 0\nf -1 2 3\nv 1 0 0\nv 0 1 0\nvn 0 0 -1\n");
    const Mesh obj = read_mesh(dir / "mesh.obj", warnings);
    EXPECT_EQ(obj.triangles, (std::vector<std::array<std::uint32_t, 3>>(2, {0, 1, 2})));
    EXPECT_EQ(obj.normals[1], Eigen::Vector3f(0, 0, -1));
    EXPECT_EQ(warnings, std::vector<std::string>{"mesh.obj: 1 invalid triangle dropped"});
    const std::string faces = "element face 2\nproperty list uchar int vertex_indices\n",
                      vertices = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
    put("mesh.ply",
        "ply\nformat ascii 1.0\n" + faces + vertices + "end_header\n3 0 1 2\n3 0 1 3\n0 0 0\n1 0 0\n0 1 0\n");
    EXPECT_EQ(read_mesh(dir / "mesh.ply", warnings).triangles.size(), 1u);
    EXPECT_EQ(warnings.back(), "mesh.ply: 1 invalid triangle dropped");
    std::string binary = "ply\nformat binary_little_endian 1.0\n" + faces + vertices + "end_header\n";
    for (const int last : {2, 3}) {
        append<std::uint8_t>(binary, 3);
        for (const int v : {0, 1, last}) append(binary, v);
    }
    for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) append(binary, x);
    put("mesh.ply", binary);
    EXPECT_EQ(read_mesh(dir / "mesh.ply", warnings).triangles.size(), 1u);
}

TEST_F(Import, NumbersThatAreNotFiniteOrTiny) {
    std::vector<std::string> warnings;
    put("mesh.obj",
        "v 0 0 0\nv 1 0 1e-400#tiny\nv 0 1 -2.5E-330\nv 0 0 1.#QNAN\nv 1 1 -1.#INF00\nvn 0 -1.#IND 1\n"
        "f 1//1 2//1 3//1\nf 1 2 4\nf 1 2 5\n");
    const Mesh obj = read_mesh(dir / "mesh.obj", warnings);
    ASSERT_EQ(obj.triangles.size(), 1u);
    EXPECT_EQ(obj.positions[1], Eigen::Vector3d(1, 0, 0));
    EXPECT_EQ(obj.normals[0], Eigen::Vector3f(0, 0, 1)) << "the face's normal";
    EXPECT_EQ(warnings, std::vector<std::string>{"mesh.obj: 2 invalid triangles dropped"});
    put("mesh.ply", replaced(survey_ply, "0.25 0 255", "-1.#IND000 0 255"));
    EXPECT_TRUE(std::isnan(read_mesh(dir / "mesh.ply", warnings).scalars[0].values[1]));
    for (const char* z : {"1e400", "1.#comment", "1e-", "1.#"}) {
        put("mesh.obj", "v 0 0 " + std::string(z) + "\n");
        EXPECT_THROW(read_mesh(dir / "mesh.obj", warnings), Error) << z;
    }
}

TEST_F(Import, StlIsWholeOrRefused) {
    const auto read = [&](const std::string& text) -> std::string {
        put("a.stl", text);
        std::vector<std::string> warnings;
        try {
            const Mesh m = read_mesh(dir / "a.stl", warnings);
            return std::to_string(m.positions.size()) + " " + std::to_string(m.triangles.size());
        } catch (const Error& e) {
            return std::string(e.what()).substr((dir / "a.stl").string().size());
        }
    };
    const std::string facet = "facet normal 1.#IND 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n",
                      end = "endloop\nendfacet\n",
                      text = "solid a #2\n" + facet + "vertex 1 1 0\nvertex 0 1 0\n" + end +
                             "endsolid\nsolid facet\n" + facet + "vertex -0 0 1\n" + end + "endsolid facet\n";
    EXPECT_EQ(read(text), "5 3");
    std::string capitals = text, carriage_returns = text;
    std::ranges::transform(capitals, capitals.begin(), [](unsigned char c) { return char(std::toupper(c)); });
    std::ranges::replace(carriage_returns, '\n', '\r');
    EXPECT_EQ(read(capitals), "5 3");
    EXPECT_EQ(read(carriage_returns), "5 3");
    EXPECT_EQ(read(replaced(text, "1 1 0", "1 x1 0")), ", line 6: expected a coordinate, found 'x1'");
    EXPECT_EQ(read(replaced(text, "1 1 0", "1,0 1 0")), ", line 6: expected a coordinate, found '1,0'");
    EXPECT_EQ(read(text.substr(0, text.rfind("endsolid"))),
              ", line 19: expected facet or endsolid, found the end of the file");
    EXPECT_EQ(read("<html>"), ", line 1: expected solid, found '<html>'");

    const auto binary = [](const char* header, std::uint32_t count, const std::string& tail) {
        std::string s(header);
        s.resize(80), append(s, count);
        for (const float x : {0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) append(s, x);
        append<std::uint16_t>(s, 0xffff);
        return s + tail;
    };
    EXPECT_EQ(read(binary("solid", 1, "")), "3 1");
    EXPECT_EQ(read(binary("solid", 1, "end")), "3 1");
    EXPECT_EQ(read(binary("", 1, std::string(428, '\0'))), "3 1") << "padded to 512 bytes";
    EXPECT_EQ(read(binary("", 2, "end")), ": is cut off: its header says 2 triangles, but the file has 1");
    EXPECT_EQ(read(binary("", ~0u, "")),
              ": is cut off: its header says 4294967295 triangles, but the file has 1");
    EXPECT_EQ(read(binary("", 0, "")), ": is damaged: its header says 0 triangles, but the file has 1");
    EXPECT_EQ(read(std::string(83, '\0')), ": is cut off: expected a header of 84 bytes");
}
