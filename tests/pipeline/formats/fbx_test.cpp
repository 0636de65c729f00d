// Meshes from FBX files, both text and binary.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <fstream>
#include <numbers>
#include <random>
#include <sstream>
#include <variant>

#include "base/text/error.h"
#include "pipeline/formats/meshes/read_mesh.h"
#include "tests/temporary_folder.h"

using namespace vantage;
using testing::ElementsAre;
using testing::HasSubstr;

namespace {

/// The name and the class of an object. Text and binary files join them differently.
struct ObjectName {
    std::string name, of;
};
using Reals = std::vector<double>;
using Integers = std::vector<int>;
using Property = std::variant<int, std::int64_t, double, std::string, ObjectName, Reals, Integers>;

/// A node of an FBX file, version 7.4, as described at code.blender.org (2013).
struct Node {
    std::string name;
    std::vector<Property> properties{};
    std::vector<Node> children{};
};

template <class T>
std::string listed(const std::vector<T>& values) {
    std::ostringstream out;
    out.precision(17);
    for (std::size_t i = 0; i < values.size(); ++i) out << (i ? "," : "") << values[i];
    return out.str();
}

struct AsText {
    std::string operator()(int v) const { return std::to_string(v); }
    std::string operator()(std::int64_t v) const { return std::to_string(v); }
    std::string operator()(double v) const { return listed(Reals{v}); }
    std::string operator()(const std::string& v) const { return '"' + v + '"'; }
    std::string operator()(const ObjectName& v) const { return '"' + v.of + "::" + v.name + '"'; }
    template <class T>
    std::string operator()(const std::vector<T>& v) const {
        return "*" + std::to_string(v.size()) + " {\na: " + listed(v) + "\n}";
    }
};

std::string text_of(const Node& node) {
    std::string out = node.name + ": ";
    for (std::size_t i = 0; i < node.properties.size(); ++i)
        out += (i ? ", " : "") + std::visit(AsText(), node.properties[i]);
    if (!node.children.empty()) {
        out += " {\n";
        for (const Node& child : node.children) out += text_of(child);
        out += "}";
    }
    return out + "\n";
}

template <class T>
std::string raw(T v) {
    return {reinterpret_cast<const char*>(&v), sizeof v};
}
std::string raw_text(const std::string& v) { return "S" + raw(std::uint32_t(v.size())) + v; }

struct AsBinary {
    std::string operator()(int v) const { return "I" + raw(v); }
    std::string operator()(std::int64_t v) const { return "L" + raw(v); }
    std::string operator()(double v) const { return "D" + raw(v); }
    std::string operator()(const std::string& v) const { return raw_text(v); }
    std::string operator()(const ObjectName& v) const {
        return raw_text(v.name + std::string("\0\1", 2) + v.of);
    }
    template <class T>
    std::string operator()(const std::vector<T>& v) const {
        const auto bytes = std::uint32_t(v.size() * sizeof(T));
        return (sizeof(T) == 8 ? "d" : "i") + raw(std::uint32_t(v.size())) + raw(0) + raw(bytes) +
               std::string(reinterpret_cast<const char*>(v.data()), bytes);
    }
};

/// `at`: the node's offset in the file.
std::string binary_of(const Node& node, std::size_t at) {
    std::string properties, children;
    for (const Property& p : node.properties) properties += std::visit(AsBinary(), p);
    const std::size_t head = 13 + node.name.size() + properties.size();
    for (const Node& child : node.children) children += binary_of(child, at + head + children.size());
    if (!node.children.empty()) children += std::string(13, '\0');
    return raw(std::uint32_t(at + head + children.size())) + raw(std::uint32_t(node.properties.size())) +
           raw(std::uint32_t(properties.size())) + char(node.name.size()) + node.name + properties + children;
}

using Nodes = std::vector<Node>;

std::string text_of(const Nodes& nodes) {
    std::string out = "; FBX 7.4.0 project file\n";
    for (const Node& node : nodes) out += text_of(node);
    return out;
}
std::string binary_of(const Nodes& nodes) {
    std::string out = std::string("Kaydara FBX Binary  \0\x1a\0", 23) + raw(7400);
    for (const Node& node : nodes) out += binary_of(node, out.size());
    return out + std::string(13, '\0');
}

Node number_property(const std::string& name, double v) { return {"P", {name, "double", "Number", "", v}}; }
Node vector_property(const std::string& name, const Eigen::Vector3d& v) {
    const std::string type = name.starts_with("Lcl ") ? name : "Vector3D";
    return {"P", {name, type, "", "A", v.x(), v.y(), v.z()}};
}
Node model(std::int64_t id, const std::string& kind, Nodes properties) {
    return {"Model",
            {id, ObjectName{"part", "Model"}, kind},
            {{"Version", {232}}, {"Properties70", {}, std::move(properties)}}};
}
/// A layer element with one value per polygon corner.
Node layer(const std::string& kind, const std::string& list, Reals values) {
    return {"LayerElement" + kind,
            {0},
            {{"Version", {101}},
             {"Name", {""}},
             {"MappingInformationType", {"ByPolygonVertex"}},
             {"ReferenceInformationType", {"Direct"}},
             {list, {std::move(values)}}}};
}
Node layer_list(const std::string& kind) {
    return {
        "Layer",
        {0},
        {{"Version", {100}}, {"LayerElement", {}, {{"Type", {"LayerElement" + kind}}, {"TypedIndex", {0}}}}}};
}
constexpr std::int64_t parent = 2001, child = 2002, geometry = 1001;

/// A file in which a parent model has a child model, which has a geometry.
Nodes file_of(Node shape, Nodes of_parent, Nodes of_child,
              Nodes settings = {number_property("UnitScaleFactor", 100)}) {
    const auto connects = [](std::int64_t a, std::int64_t b) { return Node{"C", {"OO", a, b}}; };
    return {{"FBXHeaderExtension", {}, {{"FBXHeaderVersion", {1003}}, {"FBXVersion", {7400}}}},
            {"GlobalSettings", {}, {{"Version", {1000}}, {"Properties70", {}, std::move(settings)}}},
            {"Objects",
             {},
             {std::move(shape), model(parent, "Null", std::move(of_parent)),
              model(child, "Mesh", std::move(of_child))}},
            {"Connections", {}, {connects(parent, 0), connects(child, parent), connects(geometry, child)}}};
}

/// Four corners that single precision cannot represent exactly, and the faces of a tetrahedron; the last
/// index of each face is stored as its complement.
const Reals corners{0.1, 0.2, 0.3, 1.5, 0.25, 0.125, 0.4, 1.75, 0.6, 0.3, 0.7, 2.1};
const Integers faces{0, 2, ~1, 0, 1, ~3, 1, 2, ~3, 0, 3, ~2};

Node shape_of(const Reals& vertices, const Integers& indices, Nodes layers = {}) {
    Node out{"Geometry",
             {geometry, ObjectName{"shape", "Geometry"}, "Mesh"},
             {{"Vertices", {vertices}}, {"PolygonVertexIndex", {indices}}, {"GeometryVersion", {124}}}};
    for (Node& l : layers) out.children.push_back(std::move(l));
    return out;
}

Eigen::Vector3d corner(std::size_t v) { return {corners[3 * v], corners[3 * v + 1], corners[3 * v + 2]}; }

/// `p`, rotated about x, then y, then z, by angles in degrees.
Eigen::Vector3d turned(Eigen::Vector3d p, const Eigen::Vector3d& degrees) {
    for (int axis = 0; axis < 3; ++axis) {
        const double a = degrees[axis] * std::numbers::pi / 180;
        double &u = p[(axis + 1) % 3], &v = p[(axis + 2) % 3];
        const double u_before = u;
        u = u * std::cos(a) - v * std::sin(a);
        v = u_before * std::sin(a) + v * std::cos(a);
    }
    return p;
}

class FbxMesh : public TemporaryFolder {
  protected:
    Mesh read(const std::string& bytes) {
        std::ofstream(dir / "mesh.fbx", std::ios::binary) << bytes;
        warnings.clear();
        return read_mesh(dir / "mesh.fbx", warnings);
    }
    /// The mesh read from a text and from a binary file; both must give the same mesh.
    Mesh read(const Nodes& file) {
        const Mesh text = read(text_of(file)), binary = read(binary_of(file));
        EXPECT_EQ(text.positions, binary.positions);
        EXPECT_EQ(text.triangles, binary.triangles);
        EXPECT_EQ(text.normals, binary.normals);
        EXPECT_EQ(text.colors, binary.colors);
        return binary;
    }
    std::vector<std::string> warnings;
};
class FbxMeshAtLength : public FbxMesh {};

}  // namespace

TEST_F(FbxMesh, ModelsPlaceItsGeometry) {
    const Eigen::Vector3d t1(10.5, -3, 2), r1(20, 30, 40), s1(2, 2, 2), t2(0.3, 0.2, 0.1), r2(-37, 5, 0),
        s2(1, 2, 3);
    const auto placed = [](const Eigen::Vector3d& t, const Eigen::Vector3d& r, const Eigen::Vector3d& s) {
        return Nodes{vector_property("Lcl Translation", t), vector_property("Lcl Rotation", r),
                     vector_property("Lcl Scaling", s)};
    };
    const Mesh mesh = read(file_of(shape_of(corners, faces), placed(t1, r1, s1), placed(t2, r2, s2)));
    ASSERT_EQ(mesh.positions.size(), 4u) << "shared corners are merged";
    ASSERT_EQ(mesh.triangles.size(), 4u);
    for (std::size_t f = 0; f < 4; ++f)
        for (std::size_t c = 0; c < 3; ++c) {
            const int index = faces[3 * f + c];
            const Eigen::Vector3d p = corner(std::size_t(index < 0 ? ~index : index));
            const Eigen::Vector3d in_parent = t2 + turned(p.cwiseProduct(s2), r2);
            const Eigen::Vector3d expected = t1 + turned(in_parent.cwiseProduct(s1), r1);
            EXPECT_LT((mesh.positions[mesh.triangles[f][c]] - expected).norm(), 5e-6) << f << ' ' << c;
        }
    EXPECT_THAT(warnings, ElementsAre());
}

TEST_F(FbxMesh, PivotsAndGeometricTransformsPlaceItToo) {
    const Eigen::Vector3d pivot(1, 2, 3), before(90, 0, 0), r(0, 0, 30), geometric(0.5, 0.25, 4);
    const Mesh mesh = read(file_of(shape_of(corners, faces), {},
                                   {vector_property("RotationPivot", pivot),
                                    vector_property("PreRotation", before),
                                    {"P", {"RotationActive", "bool", "", "", 1}},
                                    vector_property("Lcl Rotation", r),
                                    vector_property("GeometricTranslation", geometric)}));
    ASSERT_EQ(mesh.triangles.size(), 4u);
    const Eigen::Vector3d expected = pivot + turned(turned(corner(0) + geometric - pivot, r), before);
    EXPECT_LT((mesh.positions[mesh.triangles[0][0]] - expected).norm(), 5e-6);
}

TEST_F(FbxMesh, UnitAndAxesAreNotConverted) {
    const auto with_unit = [&](double cm) {
        return file_of(shape_of(corners, faces), {}, {},
                       {number_property("UnitScaleFactor", cm),
                        {"P", {"UpAxis", "int", "Integer", "", 2}},
                        {"P", {"FrontAxis", "int", "Integer", "", 1}},
                        {"P", {"FrontAxisSign", "int", "Integer", "", -1}}});
    };
    for (const double cm : {100.0, 1.0, 2.54}) {
        const Mesh mesh = read(with_unit(cm));
        EXPECT_LT((mesh.positions[mesh.triangles[0][0]] - corner(0)).norm(), 1e-7) << cm;
        EXPECT_EQ(warnings.size(), cm == 100 ? 0u : 1u) << cm;
    }
    EXPECT_THAT(warnings, ElementsAre("mesh.fbx: says that its unit is 2.54 cm; its coordinates are used as "
                                      "written, in the cameras' unit"));
}

TEST_F(FbxMesh, PolygonsAreTriangulatedWithinTheirOutline) {
    // An L with six corners. A triangle fan about the first corner would extend outside the outline.
    const Mesh mesh = read(file_of(
        shape_of({2, 0, 0, 2, 1, 0, 1, 1, 0, 1, 2, 0, 0, 2, 0, 0, 0, 0}, {0, 1, 2, 3, 4, ~5}), {}, {}));
    ASSERT_EQ(mesh.triangles.size(), 4u);
    double area = 0;
    for (const auto& t : mesh.triangles) {
        const Eigen::Vector3d a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
        const double signed_area = 0.5 * (b - a).cross(c - a).z();
        EXPECT_GT(signed_area, 0);
        area += signed_area;
    }
    EXPECT_NEAR(area, 3, 1e-6);
}

TEST_F(FbxMesh, KeepsNormalsAndColors) {
    Reals normals, colors;
    for (int corner = 0; corner < 3; ++corner) {
        normals.insert(normals.end(), {0.6, 0, 0.8});
        colors.insert(colors.end(), {1, 0.5, 0, 0});
    }
    const Mesh mesh =
        read(file_of(shape_of({0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, ~2},
                              {layer("Normal", "Normals", normals), layer("Color", "Colors", colors),
                               layer_list("Normal"), layer_list("Color")}),
                     {vector_property("Lcl Rotation", {0, 90, 0})}, {}));
    ASSERT_EQ(mesh.normals.size(), 3u);
    EXPECT_TRUE(mesh.normals[0].isApprox(Eigen::Vector3f(0.8f, 0, -0.6f), 1e-5f))
        << mesh.normals[0].transpose();
    ASSERT_EQ(mesh.colors.size(), 3u);
    EXPECT_EQ(mesh.colors[0], (std::array<std::uint8_t, 4>{255, 128, 0, 255}));
}

TEST_F(FbxMesh, SinglePrecisionFarFromZeroIsReported) {
    read(file_of(shape_of(corners, faces), {vector_property("Lcl Translation", {500000.123, 4200000.456, 0})},
                 {}));
    EXPECT_THAT(warnings, ElementsAre(HasSubstr("mesh.fbx: coordinates may be off by 0.25")));
}

TEST_F(FbxMeshAtLength, DamagedFilesAreReadOrRefused) {
    const Nodes nodes =
        file_of(shape_of(corners, faces), {vector_property("Lcl Translation", {1, 2, 3})}, {});
    const auto try_to_read = [&](const std::string& bytes) {
        try {
            const Mesh mesh = read(bytes);
            for (const auto& t : mesh.triangles)
                for (const std::uint32_t v : t) EXPECT_LT(v, mesh.positions.size());
        } catch (const Error& e) {
            EXPECT_EQ(e.code(), Exit::input);
            EXPECT_THAT(e.what(), HasSubstr("mesh.fbx: "));
            EXPECT_EQ(std::ranges::count(std::string(e.what()), '\n'), 0) << e.what();
        }
    };
    std::mt19937 random(5);
    for (const std::string& whole : {text_of(nodes), binary_of(nodes)}) {
        for (std::size_t n = 0; n < whole.size(); n += 61) try_to_read(whole.substr(0, n));
        for (int i = 0; i < 75; ++i) {
            std::string bytes = whole;
            for (int j = 0; j < 3; ++j) bytes[random() % bytes.size()] = char(random());
            try_to_read(bytes);
        }
    }
    EXPECT_THROW(read("solid box"), Error);
}
