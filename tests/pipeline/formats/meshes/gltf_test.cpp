// Meshes from glTF and GLB files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <fstream>
#include <numbers>
#include <random>

#include "base/text/error.h"
#include "pipeline/formats/meshes/read_mesh.h"
#include "tests/gltf_file.h"
#include "tests/temporary_folder.h"

using namespace vantage;
using testing::ElementsAre;
using testing::HasSubstr;

namespace {

using Floats = std::vector<std::array<float, 3>>;
using Indices = std::vector<std::array<std::uint16_t, 1>>;

const Floats four_corners{{0.1f, 0.2f, 0.3f}, {1.5f, 0.25f, 0.125f}, {0.4f, 1.75f, 0.6f}, {0.3f, 0.7f, 2.1f}};
const Indices tetrahedron{{0}, {2}, {1}, {0}, {1}, {3}, {1}, {2}, {3}, {0}, {3}, {2}};

Eigen::Vector3d vector(const std::array<float, 3>& v) { return {double(v[0]), double(v[1]), double(v[2])}; }

/// `p`, rotated about a unit axis by an angle in degrees (Rodrigues).
Eigen::Vector3d turned(const Eigen::Vector3d& p, const Eigen::Vector3d& axis, double degrees) {
    const double a = degrees * std::numbers::pi / 180;
    return p * std::cos(a) + axis.cross(p) * std::sin(a) + axis * axis.dot(p) * (1 - std::cos(a));
}
/// The rotation of turned() as a member of a node.
std::string rotation(const Eigen::Vector3d& axis, double degrees) {
    const double half = degrees * std::numbers::pi / 360;
    std::ostringstream out;
    out.precision(17);
    out << "\"rotation\": [" << axis.x() * std::sin(half) << ", " << axis.y() * std::sin(half) << ", "
        << axis.z() * std::sin(half) << ", " << std::cos(half) << "]";
    return out.str();
}

class GltfMesh : public TemporaryFolder {
  protected:
    void write(const std::string& name, const std::string& bytes) const {
        std::filesystem::create_directories((dir / name).parent_path());
        std::ofstream(dir / name, std::ios::binary) << bytes;
    }
    Mesh read(const std::string& name) {
        warnings.clear();
        return read_mesh(dir / name, warnings, &companions);
    }
    Mesh read(const GltfFile& file) {
        write("mesh.glb", file.glb());
        return read("mesh.glb");
    }
    std::string error_of(const std::string& name) {
        try {
            read(name);
        } catch (const Error& e) {
            EXPECT_EQ(e.code(), Exit::input);
            return e.what();
        }
        return "none";
    }
    /// A file with the mesh of the tetrahedron, but without a node.
    static GltfFile mesh_of(const Floats& positions, const std::string& more = "") {
        GltfFile file;
        const std::string attributes = "\"attributes\": {\"POSITION\": " + file.add(positions) + more + "}";
        file.add_mesh(attributes + ", \"indices\": " + file.add(tetrahedron));
        return file;
    }
    static double signed_volume(const Mesh& m) {
        double sum = 0;
        for (const auto& t : m.triangles)
            sum += m.positions[t[0]].dot(m.positions[t[1]].cross(m.positions[t[2]])) / 6;
        return sum;
    }
    std::vector<std::string> warnings;
    std::vector<std::filesystem::path> companions;
};

const Eigen::Vector3d x(1, 0, 0), skew = Eigen::Vector3d(1, -2, 3).normalized();

}  // namespace

TEST_F(GltfMesh, NodesPlaceItsMeshes) {
    GltfFile file = mesh_of(four_corners);
    file.add_node("\"translation\": [4200000.123, -7.25, 1e-4], " + rotation(skew, 50) +
                  ", \"scale\": [2, 2, 2], \"children\": [1, 2]");
    file.add_node("\"translation\": [0.3, 0.2, 0.1], " + rotation(x, -37) +
                  ", \"scale\": [1, 2, 3], \"mesh\": 0");
    file.add_node("\"matrix\": [0, 1, 0, 0,  -1, 0, 0, 0,  0, 0, 1, 0,  10, 20, 30, 1], \"mesh\": 0");
    const Mesh mesh = read(file);
    ASSERT_EQ(mesh.positions.size(), 8u) << "the mesh is placed twice";
    EXPECT_EQ(mesh.triangles.size(), 8u);
    for (std::size_t v = 0; v < 4; ++v) {
        const Eigen::Vector3d p = vector(four_corners[v]), first(0.3, 0.2, 0.1),
                              parent(4200000.123, -7.25, 1e-4);
        const Eigen::Vector3d in_parent = first + turned(p.cwiseProduct(Eigen::Vector3d(1, 2, 3)), x, -37);
        EXPECT_LT((mesh.positions[v] - (parent + turned(2 * in_parent, skew, 50))).norm(), 2e-9) << v;
        const Eigen::Vector3d quarter(10 - p.y(), 20 + p.x(), 30 + p.z());
        EXPECT_LT((mesh.positions[4 + v] - (parent + turned(2 * quarter, skew, 50))).norm(), 2e-9) << v;
    }
    EXPECT_THAT(warnings, ElementsAre());
}

TEST_F(GltfMesh, NormalsStayPerpendicularIfNodesStretch) {
    const Floats normals{{1, 0, 0}, {0, 0.6f, 0.8f}, {-0.8f, 0, 0.6f}, {0, 0, 1}};
    GltfFile file;
    file.add_mesh("\"attributes\": {\"POSITION\": " + file.add(four_corners) +
                  ", \"NORMAL\": " + file.add(normals) + "}, \"indices\": " + file.add(tetrahedron));
    file.add_node(rotation(skew, 50) + ", \"scale\": [1, 4, 0.5], \"children\": [1]");
    file.add_node(rotation(x, -37) + ", \"scale\": [-1, 2, 3], \"mesh\": 0");
    const Mesh mesh = read(file);
    for (std::size_t v = 0; v < 4; ++v) {
        // The inverse transpose of a scaling is the inverse scaling.
        const Eigen::Vector3d n = turned(vector(normals[v]).cwiseQuotient(Eigen::Vector3d(-1, 2, 3)), x, -37);
        const Eigen::Vector3d expected = turned(n.cwiseQuotient(Eigen::Vector3d(1, 4, 0.5)), skew, 50);
        EXPECT_LT((mesh.normals[v].cast<double>() - expected.normalized()).norm(), 1e-6) << v;
    }
}

TEST_F(GltfMesh, MirroredMeshesKeepTheirOutside) {
    GltfFile file = mesh_of(four_corners);
    file.add_node("\"mesh\": 0");
    const double volume = signed_volume(read(file));
    file.nodes.clear();
    file.add_node("\"scale\": [1, 1, -2], \"mesh\": 0");
    EXPECT_NEAR(signed_volume(read(file)), 2 * volume, 1e-6);
    EXPECT_GT(volume, 0.1);
}

TEST_F(GltfMesh, FlattenedMeshesHaveNormals) {
    for (const char* scale : {"[1, 1, 0]", "[1, 0, 0]", "[0, 0, 0]", "[1e12, 1e-12, 1]"}) {
        GltfFile file;
        file.add_mesh("\"attributes\": {\"POSITION\": " + file.add(four_corners) +
                      ", \"NORMAL\": " + file.add(four_corners) + "}, \"indices\": " + file.add(tetrahedron));
        file.add_node(std::string("\"mesh\": 0, \"scale\": ") + scale);
        for (const Eigen::Vector3f& n : read(file).normals) EXPECT_NEAR(n.norm(), 1, 1e-5f) << scale;
    }
}

TEST_F(GltfMesh, ReadsItsBufferFromTheFileAndFromFilesBesideIt) {
    GltfFile file = mesh_of(four_corners);
    file.add_node("\"mesh\": 0");
    const Mesh in_glb = read(file);
    EXPECT_THAT(companions, ElementsAre());
    EXPECT_EQ(in_glb.positions.size(), 4u);
    write("parts/my scan.bin", file.bytes);
    for (const char* uri : {"parts/my scan.bin", "parts/my%20scan.bin"}) {
        write("mesh.gltf", file.json(uri));
        EXPECT_EQ(read("mesh.gltf").positions, in_glb.positions) << uri;
        EXPECT_THAT(companions, ElementsAre(dir / "parts/my scan.bin"));
    }
}

TEST_F(GltfMesh, SeamsAreClosedAndEdgesStaySharp) {
    // A square made of two triangles that share no vertices, as at a texture seam.
    const Floats square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    Floats normals(6, {0, 0, 1});
    for (const bool sharp : {false, true}) {
        if (sharp) normals[2] = {1, 0, 0};
        GltfFile file;
        file.add_mesh("\"attributes\": {\"POSITION\": " + file.add(square) +
                      ", \"NORMAL\": " + file.add(normals) + "}");
        file.add_node("\"mesh\": 0");
        const Mesh mesh = read(file);
        EXPECT_EQ(mesh.positions.size(), sharp ? 5u : 4u);
        EXPECT_THAT(mesh.triangles,
                    ElementsAre(std::array{0u, 1u, 2u}, std::array{0u, sharp ? 3u : 2u, sharp ? 4u : 3u}));
    }
}

TEST_F(GltfMesh, ColorsAreLinearLightAndOpaque) {
    const std::vector<std::array<std::uint8_t, 4>> bytes{
        {0, 55, 255, 9}, {55, 55, 55, 9}, {0, 0, 0, 9}, {1, 2, 3, 9}};
    GltfFile file;
    file.add_mesh("\"attributes\": {\"POSITION\": " + file.add(four_corners) +
                  ", \"COLOR_0\": " + file.add(bytes) + "}, \"indices\": " + file.add(tetrahedron));
    // The linear value 0.2158605 is 128 / 255 in sRGB, and 0.0030353 is 10 / 255.
    const Floats numbers{{0.2158605f, 0, 1}, {0.0030353f, 1, 1}, {2, -1, 0}, {NAN, 1, 1}};
    file.add_mesh("\"attributes\": {\"POSITION\": " + file.add(four_corners) +
                  ", \"COLOR_0\": " + file.add(numbers) + "}, \"indices\": " + file.add(tetrahedron));
    file.add_mesh("\"attributes\": {\"POSITION\": " + file.add(four_corners) +
                  "}, \"indices\": " + file.add(tetrahedron));
    file.roots = "0, 1, 2";
    file.add_node("\"mesh\": 0");
    file.add_node("\"translation\": [0, 0, 5], \"mesh\": 1");
    file.add_node("\"translation\": [0, 0, 9], \"mesh\": 2");
    using Color = std::array<std::uint8_t, 4>;
    const std::vector<Color> colors = read(file).colors;
    ASSERT_EQ(colors.size(), 12u);
    EXPECT_EQ(colors[0], (Color{0, 128, 255, 255})) << "55 / 255 is 128 / 255 in sRGB";
    EXPECT_EQ(colors[4], (Color{128, 0, 255, 255}));
    EXPECT_EQ(colors[5], (Color{10, 255, 255, 255}));
    EXPECT_EQ(colors[6], (Color{255, 0, 0, 255}));
    EXPECT_EQ(colors[7], (Color{0, 255, 255, 255}));
    EXPECT_EQ(colors[8], (Color{255, 255, 255, 255})) << "the default of a mesh without colors";
}

TEST_F(GltfMesh, LinesAndPointsAreSkipped) {
    GltfFile file = mesh_of(four_corners);
    const std::string position = "\"attributes\": {\"POSITION\": " + file.add(four_corners) + "}";
    file.add_mesh(position + ", \"mode\": 0");
    file.add_mesh(position + ", \"mode\": 3");
    file.add_mesh(position + ", \"mode\": 5");
    file.roots = "0, 1, 2, 3";
    for (int m = 0; m < 4; ++m)
        file.add_node("\"translation\": [0, 0, " + std::to_string(9 * m) +
                      "], \"mesh\": " + std::to_string(m));
    EXPECT_EQ(read(file).triangles.size(), 4u + 2u) << "the tetrahedron, and a strip of two";
    file.roots = "1";
    EXPECT_TRUE(read(file).points_only());
    file.roots = "";
    write("mesh.glb", file.glb());
    EXPECT_THAT(error_of("mesh.glb"), HasSubstr("mesh.glb: has no vertices"));
}

TEST_F(GltfMesh, SinglePrecisionFarFromZeroIsReported) {
    Floats far = four_corners;
    for (auto& p : far) p[0] += 500000, p[1] += 4200000;
    GltfFile file = mesh_of(far);
    file.add_node(rotation(skew, 50) + ", \"mesh\": 0");
    read(file);
    EXPECT_THAT(warnings, ElementsAre(HasSubstr("mesh.glb: coordinates may be off by 0.4")));
}

TEST_F(GltfMesh, FilesThatCannotBeReadAreRefusedInOneLine) {
    GltfFile file = mesh_of(four_corners);
    file.add_node("\"mesh\": 0");
    const auto error = [&](const std::string& json) {
        write("mesh.gltf", json);
        const std::string text = error_of("mesh.gltf");
        EXPECT_EQ(std::ranges::count(text, '\n'), 0) << text;
        EXPECT_THAT(text, HasSubstr("mesh.gltf: "));
        return text;
    };
    EXPECT_THAT(error(file.json("none.bin")), HasSubstr("its buffer none.bin is missing"));
    write("scan.bin", file.bytes.substr(1));
    EXPECT_THAT(error(file.json("scan.bin")), HasSubstr("exceeds size of actual data"));
    write("scan.bin", file.bytes);
    std::filesystem::create_directories(dir / "below");
    write("below/mesh.gltf", file.json("../scan.bin"));
    EXPECT_THAT(error_of("below/mesh.gltf"), HasSubstr("buffers[0].uri: found \"../scan.bin\", expected"));
    EXPECT_THAT(error(file.json((dir / "scan.bin").string())), HasSubstr("in the folder of the glTF"));
    file.more = ", \"extensionsRequired\": [\"KHR_materials_unlit\", \"KHR_mesh_quantization\"]";
    EXPECT_THAT(error(file.json("scan.bin")), HasSubstr("needs the glTF extension KHR_mesh_quantization"));
    file.more = "";
    EXPECT_THAT(error("{\"asset\": {\"version\": \"1.0\"}}"), HasSubstr("glTF version 1.0, expected 2.0"));
    EXPECT_THAT(error("solid box"), HasSubstr("is not JSON"));
    file.nodes.clear();
    file.add_node("\"children\": [1], \"mesh\": 0");
    file.add_node("\"children\": [0]");
    EXPECT_THAT(error(file.json("scan.bin")),
                HasSubstr("nodes[0]: found an object, expected a node with one parent"));
}

TEST_F(GltfMesh, DamagedFilesAreReadOrRefused) {
    GltfFile file = mesh_of(four_corners);
    file.add_node("\"translation\": [1, 2, 3], \"children\": [1]");
    file.add_node("\"matrix\": [0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 10, 20, 30, 1], \"mesh\": 0");
    const std::string whole = file.glb();
    const auto try_to_read = [&](const std::string& bytes) {
        write("mesh.glb", bytes);
        try {
            const Mesh mesh = read("mesh.glb");
            for (const auto& t : mesh.triangles)
                for (const std::uint32_t v : t) EXPECT_LT(v, mesh.positions.size());
            return true;
        } catch (const Error& e) {
            EXPECT_THAT(e.what(), HasSubstr("mesh.glb: "));
            EXPECT_EQ(std::ranges::count(std::string(e.what()), '\n'), 0) << e.what();
            return false;
        }
    };
    EXPECT_TRUE(try_to_read(whole));
    for (std::size_t n = 0; n < whole.size(); n += 7) EXPECT_FALSE(try_to_read(whole.substr(0, n))) << n;
    std::mt19937 random(5);
    for (int i = 0; i < 200; ++i) {
        std::string bytes = whole;
        for (int j = 0; j < 3; ++j) bytes[random() % bytes.size()] = char(random());
        try_to_read(bytes);
    }
}
