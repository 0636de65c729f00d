// Materials of OBJ files.
#include "pipeline/formats/meshes/mtl.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "base/text/error.h"
#include "pipeline/formats/meshes/read_mesh.h"
#include "tests/temporary_folder.h"

using namespace vantage;

namespace {

class Mtl : public TemporaryFolder {
  protected:
    void write(const std::string& name, const std::string& text) const {
        std::filesystem::create_directories((dir / name).parent_path());
        std::ofstream(dir / name) << text;
    }
    std::map<std::string, MaterialColor> materials(const std::string& text) {
        write("a.mtl", text);
        return read_mtl(dir / "a.mtl", warnings);
    }
    Mesh mesh(const std::string& text) {
        write("mesh.obj", text);
        return read_mesh(dir / "mesh.obj", warnings, &files);
    }
    static std::string replaced(std::string text, const std::string& what, const std::string& by) {
        return text.replace(text.find(what), what.size(), by);
    }
    std::vector<std::string> warnings;
    std::vector<std::filesystem::path> files;
};

/// A roof with two slopes that meet at the edge between vertices 1 and 2.
const std::string roof =
    "v 0 0 1\nv 0 2 1\nv 1 0 0\nv -1 0 0\nusemtl tiles\nf 1 3 2\nusemtl skylight\nf 1 2 4\n";

}  // namespace

TEST_F(Mtl, GivesColorAndAlpha) {
    const auto m = materials(
        "# a comment\nKd 9 9 9\nnewmtl glass pane\r\n  Kd 1 0.5 0\r\n\td 0.4 # clear\r\nnewmtl old\nTr 0.4\n"
        "newmtl both\nTr 0.4\nd 0.2\nTr 0.9\nnewmtl halo\nd -halo 0.6\nnewmtl plain\nNs 10\nnewmtl "
        "bright\nKd 2 +.2 -1\nnewmtl hole\nd 1e-400");
    EXPECT_EQ(m.size(), 7u);
    EXPECT_EQ(m.at("hole")[3], 0);
    EXPECT_EQ(m.at("glass pane"), (MaterialColor{255, 128, 0, 102}));
    EXPECT_EQ(m.at("old"), (MaterialColor{255, 255, 255, 153})) << "Tr is the transparency";
    EXPECT_EQ(m.at("both")[3], 51) << "d counts";
    EXPECT_EQ(m.at("halo")[3], 153);
    EXPECT_EQ(m.at("plain"), (MaterialColor{255, 255, 255, 255}));
    EXPECT_EQ(m.at("bright"), (MaterialColor{255, 51, 0, 255})) << "clamped";
    EXPECT_TRUE(warnings.empty());
}

TEST_F(Mtl, NamesMayHaveNumberSigns) {
    const std::string faces =
        "v 0 0 1\nv 0 2 1\nv 1 0 0\nv -1 0 0\nusemtl Material #25\nf 1 3 2\nusemtl Material  #26\nf 1 2 4\n";
    write("scan #2.mtl", "newmtl Material #25\nd 1\nnewmtl Material #26\nd 0.3 # glass\n");
    const Mesh m = mesh("mtllib scan #2.mtl\n" + faces);
    EXPECT_EQ(files.size(), 1u);
    EXPECT_EQ(std::ranges::count_if(m.colors, [](const auto& c) { return c[3] == 77; }), 3)
        << "the corners of one triangle";
    EXPECT_TRUE(warnings.empty()) << warnings.front();
    // A name may consist only of a color, and a comment may follow it.
    const auto known =
        materials("newmtl #FF0000\nd 0.5\nnewmtl #00FF00\nd 1\nnewmtl oak # of the door\nd 0.25\n");
    EXPECT_EQ(material_named(known, "#FF0000").value()[3], 128);
    EXPECT_EQ(material_named(known, "#00FF00").value()[3], 255);
    EXPECT_EQ(material_named(known, "oak").value()[3], 64);
    EXPECT_FALSE(material_named(known, "ash"));
    // A # before a number does not start a comment.
    const auto numbered = materials("newmtl Glass #1 # frame\nd 1\nnewmtl Glass #2 # pane\nd 0.25\n");
    EXPECT_EQ(material_named(numbered, "Glass #2").value()[3], 64);
    EXPECT_FALSE(material_named(numbered, "Glass #3"));
    EXPECT_FALSE(material_named(numbered, "Glass"));
}

TEST_F(Mtl, SaysWhatCannotBeRead) {
    const auto m = materials(
        "newmtl a\nKd spectral x.rfl\nd much\nnewmtl b\nd nan\nnewmtl c\nd\nnewmtl "
        "d\nmap_d hole.png\n");
    EXPECT_EQ(m.at("a"), (MaterialColor{255, 255, 255, 255}));
    EXPECT_EQ(m.at("b")[3], 255);
    EXPECT_EQ(warnings,
              (std::vector<std::string>{
                  "a.mtl, line 2: expected three numbers after Kd; the color is assumed to be white",
                  "a.mtl, line 5: expected a number from 0 to 1 as alpha; the value is ignored",
                  "a.mtl, line 7: expected a number from 0 to 1 as alpha; the value is ignored",
                  "a.mtl, line 9: alpha from a texture (map_d) is not read"}));
}

TEST_F(Mtl, SplitsVerticesBetweenMaterialsAndKeepsTheirNormals) {
    write("a.mtl", "newmtl tiles\nKd 1 0 0\nnewmtl skylight\nKd 0 0 1\nd 0.2\n");
    const Mesh without = mesh(roof);
    EXPECT_TRUE(without.colors.empty());
    EXPECT_TRUE(files.empty());
    const Mesh m = mesh("mtllib a.mtl\n" + roof);
    ASSERT_EQ(m.positions.size(), 6u) << "both vertices of the ridge are split";
    EXPECT_EQ(files, std::vector{dir / "a.mtl"});
    for (const std::uint32_t v : m.triangles[0]) EXPECT_EQ(m.colors[v], (MaterialColor{255, 0, 0, 255}));
    for (const std::uint32_t v : m.triangles[1]) EXPECT_EQ(m.colors[v], (MaterialColor{0, 0, 255, 51}));
    for (std::size_t t = 0; t < 2; ++t)
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t now = m.triangles[t][c], before = without.triangles[t][c];
            EXPECT_EQ(m.positions[now], without.positions[before]);
            EXPECT_LT((m.normals[now] - without.normals[before]).norm(), 1e-6f) << "no crease at the ridge";
        }
    EXPECT_TRUE(warnings.empty());
}

TEST_F(Mtl, AreNotUsedIfAllAreOpaque) {
    write("a.mtl", "newmtl tiles\nKd 1 0 0\nnewmtl skylight\nKd 0 0 1\nnewmtl unused\nd 0.1\n");
    const Mesh m = mesh("mtllib a.mtl\n" + roof);
    EXPECT_TRUE(m.colors.empty());
    EXPECT_EQ(m.positions.size(), 4u);
    EXPECT_EQ(files, std::vector{dir / "a.mtl"}) << "read in case it becomes transparent";
}

TEST_F(Mtl, KeepColorsOfVertices) {
    write("a.mtl", "newmtl glass\nKd 0 0 1\nd 0.2\n");
    const Mesh m = mesh(
        "mtllib a.mtl\nv 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nv 1 1 0 1 1 0\nf 1 2 3\n"
        "usemtl glass\nf 2 4 3\n");
    EXPECT_EQ(m.positions.size(), 6u);
    EXPECT_EQ(m.colors[0], (MaterialColor{255, 0, 0, 255}));
    EXPECT_EQ(m.colors[3], (MaterialColor{255, 255, 0, 51}));
    EXPECT_EQ(m.colors[m.triangles[1][0]], (MaterialColor{0, 255, 0, 51}));
}

TEST_F(Mtl, AreFoundAsExportersNameThem) {
    write("my materials.mtl", "newmtl tiles\nnewmtl skylight\nd 0.5\n");
    write("sub/b.mtl", "newmtl tiles\nnewmtl skylight\nd 0.25\n");
    EXPECT_EQ(mesh("mtllib my materials.mtl\n" + roof).colors[5][3], 128);
    EXPECT_EQ(mesh("mtllib C:\\work\\my materials.mtl\n" + roof).colors[5][3], 128);
    EXPECT_EQ(mesh("mtllib sub\\b.mtl\n" + roof).colors[5][3], 64);
    for (const char* name : {"\"my materials.mtl\"", "My Materials.MTL", "my materials.mtl # of the roof"})
        EXPECT_EQ(mesh("mtllib " + std::string(name) + "\n" + roof).colors.at(5)[3], 128) << name;
    write("a  #2.mtl", "newmtl tiles\nnewmtl skylight\nd 0.75\n");
    EXPECT_EQ(mesh("mtllib a  #2.mtl # x\n" + roof).colors.at(5)[3], 191);
    write("m\u00fc.mtl", "newmtl tiles\nnewmtl skylight\nd 0.25\n");
    EXPECT_EQ(mesh("mtllib mu\u0308.mtl\n" + roof).colors.at(5)[3], 64);
    EXPECT_TRUE(warnings.empty());
    EXPECT_TRUE(mesh("mtllib none.mtl\nmtllib none.mtl\n" + roof).colors.empty());
    EXPECT_EQ(files, std::vector{dir / "none.mtl"}) << "listed in case it is added";
    write("MY materials.mtl", "newmtl skylight\n");
    EXPECT_TRUE(mesh("mtllib My Materials.mtl\n" + roof).colors.empty()) << "two candidates";
    ASSERT_EQ(warnings.size(), 2u);
    EXPECT_EQ(warnings[0],
              "mesh.obj: its material file none.mtl is missing; faces that use its materials are treated as "
              "opaque");
}

TEST_F(Mtl, OfTheSameName) {
    write("z.mtl", "newmtl tiles\nnewmtl skylight\nd 0.5\n");
    write("a.mtl", "newmtl skylight\nd 0.25\n");
    EXPECT_EQ(mesh("mtllib z.mtl\nmtllib a.mtl\nmtllib z.mtl\n" + roof).colors.at(5)[3], 128);
    EXPECT_TRUE(warnings.empty());
    const auto m = materials("newmtl a\nd 0.5\nnewmtl a\nd 0.5\nnewmtl b\nnewmtl b\nd 0\n");
    EXPECT_EQ(m.at("b")[3], 0);
    EXPECT_EQ(warnings,
              std::vector<std::string>{
                  "a.mtl, line 6: the material is defined twice, with different values; the last is used"});
}

TEST_F(Mtl, AreMissedIfFacesUseThem) {
    write("a.mtl", "newmtl Skylight\nd 0.5\n");
    EXPECT_TRUE(mesh("mtllib a.mtl\nusemtl unused\n" + roof).colors.empty());
    EXPECT_EQ(warnings, std::vector<std::string>{"a.mtl: has no material 'tiles' and 1 other, which faces of "
                                                 "mesh.obj use; these faces are treated as opaque"});
}

TEST_F(Mtl, AreNotSwallowedByCommentsAndNames) {
    write("a.mtl", "newmtl tiles\nnewmtl skylight\nd 0.5\n");
    for (const char* line : {"#C:\\scans\\", "#\\", "# a \\", "g C:\\scans\\", "o wall #3\\", "v 9 9 9 #\\"})
        EXPECT_EQ(mesh("mtllib a.mtl\n" + replaced(roof, "usemtl sky", line + std::string("\nusemtl sky")))
                      .colors.at(5)[3],
                  128)
            << line;
    const std::string continued =
        replaced(replaced(roof, "f 1 2 4", "f 1 2\\\n 4"), "usemtl sky", "usemtl \\\nsky");
    EXPECT_EQ(mesh("mtllib a.mtl\n" + continued).colors.at(5)[3], 128);
    write("a.mtl", "newmtl skylight\\\nd 0.5\n");
    EXPECT_EQ(mesh("mtllib a.mtl\n" + replaced(roof, "skylight", "skylight\\")).colors.at(5)[3], 128);
}

TEST_F(Mtl, DoNotHideWrongFaces) {
    write("a.mtl", "newmtl glass\nd 0.2\n");
    const Mesh m =
        mesh("mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\nusemtl glass\nf 1 2 3\nf 1 2 9\nf 1 2 4\n");
    EXPECT_EQ(m.triangles.size(), 1u);
    EXPECT_EQ(warnings, std::vector<std::string>{"mesh.obj: 2 invalid triangles dropped"});
    for (const Eigen::Vector3f& n : m.normals) EXPECT_TRUE(n.allFinite());
}
