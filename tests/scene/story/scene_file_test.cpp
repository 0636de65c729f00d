#include "scene/story/scene_file.h"

#include <gtest/gtest.h>

#include <fstream>

#include "base/text/error.h"
#include "tests/temporary_folder.h"

using namespace vantage;

namespace {

class SceneFile : public TemporaryFolder {
  protected:
    std::filesystem::path written(const std::string& text) const {
        std::ofstream(dir / "church.toml") << text;
        return dir / "church.toml";
    }
    std::string error_of(const std::string& text, SceneUse use = SceneUse::show) const {
        try {
            read_scene_file(written(text), use);
        } catch (const Error& e) {
            EXPECT_EQ(e.code(), Exit::input);
            std::string what = e.what();
            EXPECT_EQ(what.rfind(dir.string(), 0), 0u) << what;
            EXPECT_EQ(what.find('\n'), std::string::npos) << what;
            return what.substr((dir / "church.toml").string().size());
        }
        return "accepted";
    }
};

}  // namespace

TEST_F(SceneFile, IsReadBackAsItWasWritten) {
    std::vector<SceneObject> objects{{"nave", dir / "packages" / "nave.vantage", {}, true},
                                     {"the \"altar\"", dir / "altar.vantage", {}, false}};
    objects[1].opacity = 0.25;
    objects[1].placement = {{1.25, -3, 1e-7}, {0, 90, -12.5}, 0.01};
    write_scene_file(dir / "church.toml", objects);
    const std::vector<SceneObject> read = read_scene_file(dir / "church.toml", SceneUse::show);
    ASSERT_EQ(read.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(read[i].name, objects[i].name);
        EXPECT_EQ(read[i].package.lexically_normal(), objects[i].package);
        EXPECT_EQ(read[i].placement, objects[i].placement);
        EXPECT_EQ(read[i].shown, objects[i].shown);
        EXPECT_EQ(read[i].opacity, objects[i].opacity);
    }
    // Packages are stored relative to the folder, so that the folder can be moved.
    EXPECT_NE(scene_file_text(objects, dir).find("packages/nave.vantage"), std::string::npos);
    EXPECT_EQ(scene_file_text(objects, dir).find(dir.string()), std::string::npos);
}

TEST_F(SceneFile, InputsAreReadBackWithTheirAlignment) {
    SceneObject altar;
    altar.name = "altar";
    altar.input = {{}, dir / "m.ply", dir / "sparse", dir / "photos", {dir / "a.ply"}};
    Similarity s;
    s.R << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    s.t = {4e5, -1.0 / 3, 7};
    s.scale = 0.0123456789012345678;
    altar.input.align = s;
    write_scene_file(dir / "altar.toml", {altar});
    const auto read = read_scene_file(dir / "altar.toml", SceneUse::prepare);
    ASSERT_EQ(read.size(), 1u);
    EXPECT_EQ(read[0].input.mesh.lexically_normal(), altar.input.mesh);
    EXPECT_EQ(read[0].input.points.at(0).lexically_normal(), altar.input.points[0]);
    ASSERT_TRUE(read[0].input.align);
    EXPECT_EQ(read[0].input.align->t, s.t);
    EXPECT_NEAR(read[0].input.align->scale / s.scale, 1, 1e-14);
    EXPECT_TRUE(read[0].input.align->R.isApprox(s.R, 1e-14));
    const std::string input = "[[object]]\nmesh = \"m\"\ncameras = \"c\"\nphotos = \"p\"\nalign = ";
    for (const char* bad :
         {"[1, 2, 3]", "[[1,0,0,0],[0,1,0,0],[0,0,-1,0]]", "[[1,0,0,0],[0,2,0,0],[0,0,1,0]]",
          "[[nan,0,0,0],[0,1,0,0],[0,0,1,0]]", "[[0,0,0,0],[0,0,0,0],[0,0,0,0]]", "\"x\""})
        EXPECT_EQ(
            error_of(input + bad, SceneUse::prepare),
            ": object 1: align: expected 3 rows of 4 numbers: a rotation times a scale, and a translation");
}

TEST_F(SceneFile, MatricesAreReadAsOtherProgramsWriteThem) {
    const std::string objects = "[[object]]\npackage = \"a.vantage\"\n[[object]]\npackage = \"b.vantage\"\n";
    for (const char* const text :
         {"[[0, -2, 0, 2.5], [2, 0, 0, -1], [0, 0, 2, 4e5], [0, 0, 0, 1]]",
          "[0, -2, 0, 2.5, 2, 0, 0, -1, 0, 0, 2, 400000, 0, 0, 0, 1]",
          "[[0.000001, -2, 0, 2.5], [2, 0, 0, -1], [0, 0, 2.00001, 4e5], [0, 0, 0, 1]]"}) {
        const auto read = read_scene_file(written(objects + "matrix = " + text + "\n"), SceneUse::show);
        ASSERT_TRUE(read.at(1).matrix) << text;
        EXPECT_LT(((*read[1].matrix)({1, 2, 3}) - Eigen::Vector3d(-1.5, 1, 4e5 + 6)).norm(), 1e-4) << text;
        write_scene_file(dir / "again.toml", read);
        const auto again = read_scene_file(dir / "again.toml", SceneUse::show);
        EXPECT_TRUE(matrix_of(*again.at(1).matrix).isApprox(matrix_of(*read[1].matrix), 1e-14)) << text;
    }
    for (const char* const bad :
         {"1", "[]", "[[1,0,0,0],[0,1,0,0],[0,0,1,0]]", "[1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0]",
          "[[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,2]]", "[[1,0,0,0],[0,1,0,0],[0,0,1,0],[5,0,0,1]]",
          "[[1,0.1,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]", "[[1,0,0,0],[0,2,0,0],[0,0,1,0],[0,0,0,1]]",
          "[[1,0,0,0],[0,1,0,0],[0,0,-1,0],[0,0,0,1]]", "[[nan,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]",
          "[[1,0,0,\"x\"],[0,1,0,0],[0,0,1,0],[0,0,0,1]]", "[[1,0,0,1e13],[0,1,0,0],[0,0,1,0],[0,0,0,1]]"})
        EXPECT_EQ(
            error_of(objects + "matrix = " + bad + "\n"),
            ": object 2: matrix: expected 4 rows of 4 numbers, or these 16: a rotation times a scale, a "
            "translation, and the last row 0, 0, 0, 1")
            << bad;
    const std::string one = "matrix = [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]\n";
    EXPECT_EQ(error_of(objects + one + "scale = 1\n"),
              ": object 2: matrix: replaces move, turn and scale, which must not be given as well");
    EXPECT_EQ(error_of("[[object]]\npackage = \"a\"\n" + one), "accepted");
    EXPECT_EQ(error_of("[[object]]\npackage = \"a\"\nmatrix = [1,0,0,1, 0,1,0,0, 0,0,1,0, 0,0,0,1]\n"),
              ": object 1: the scene has this object's coordinates, so it cannot be moved, turned or scaled");
}

TEST_F(SceneFile, NamesAreThoseOfThePackagesUnlessGiven) {
    const auto read = read_scene_file(written("[[object]]\npackage = \"a/nave.vantage\"\n"), SceneUse::show);
    ASSERT_EQ(read.size(), 1u);
    EXPECT_EQ(read[0].name, "nave");
    EXPECT_EQ(read[0].package, dir / "a/nave.vantage");
    EXPECT_EQ(read[0].placement, Placement{});
}

TEST_F(SceneFile, InputsAreRelativeToTheFile) {
    const auto read = read_scene_file(
        written("[[object]]\ninput = \"scans/nave/\"\n[[object]]\nmesh = \"m/altar.ply\"\ncameras = "
                "\"/c\"\nphotos = \"p\"\npoints = [\"a.ply\", \"/b.ply\"]\n"),
        SceneUse::prepare);
    ASSERT_EQ(read.size(), 2u);
    EXPECT_EQ(read[0].name, "nave");
    EXPECT_EQ(read[0].input.folder, dir / "scans/nave/");
    EXPECT_EQ(read[1].name, "altar");
    EXPECT_EQ(read[1].input.cameras, "/c");
    EXPECT_EQ(read[1].input.points, (std::vector<std::filesystem::path>{dir / "a.ply", "/b.ply"}));
}

TEST_F(SceneFile, PointsMayStandInPlaceOfAMesh) {
    const auto read =
        read_scene_file(written("[[object]]\npoints = \"scans/cloud.las\"\n[[object]]\npoints = [\"a.ply\", "
                                "\"b.ply\"]\ncameras = \"c\"\nphotos = \"p\"\n"),
                        SceneUse::prepare);
    ASSERT_EQ(read.size(), 2u);
    EXPECT_EQ(read[0].name, "cloud");
    EXPECT_EQ(read[0].input.points.at(0), dir / "scans/cloud.las");
    EXPECT_EQ(read[1].name, "a");
    EXPECT_EQ(read[1].input.photos, dir / "p");
}

TEST_F(SceneFile, ErrorsNameTheObjectAndWhatWasExpected) {
    const std::string first = "[[object]]\npackage = \"a.vantage\"\n",
                      second = "[[object]]\npackage = \"b.vantage\"\n";
    EXPECT_EQ(error_of(""), ": has no [[object]]");
    EXPECT_EQ(error_of("object = 3\n"), ": unknown key 'object', expected [[object]]");
    EXPECT_EQ(error_of("[[objects]]\npackage = \"a\"\n"), ": unknown key 'objects', expected [[object]]");
    EXPECT_EQ(error_of("[[object]]\nname = \"a\"\n"), ": object 1: has no package");
    EXPECT_EQ(error_of("[[object]]\npackage = 3\n"), ": object 1: package: expected a non-empty string");
    EXPECT_EQ(error_of(first + "move = [1, 0, 0]\n"),
              ": object 1: the scene has this object's coordinates, so it cannot be moved, turned or scaled");
    for (const char* move : {"[1, 2]", "[1, 2, \"x\"]", "1", "[nan, 0, 0]", "[inf, 0, 0]", "[1e13, 0, 0]"})
        EXPECT_EQ(error_of(first + second + "move = " + move + "\n"),
                  ": object 2: move: expected three numbers, such as [1, 0, 0.5]");
    for (const char* scale : {"0", "-1", "nan", "inf", "1e-9", "\"1\""})
        EXPECT_EQ(error_of(first + second + "scale = " + scale + "\n"),
                  ": object 2: scale: expected a number from 1e-06 to 1e+06");
    EXPECT_EQ(error_of(first + second + "shown = 1\n"), ": object 2: shown: expected true or false");
    EXPECT_EQ(error_of(first + second + "rotate = 1\n"),
              ": object 2: unknown key 'rotate', expected name, package, input, mesh, cameras, photos, "
              "points, align, move, turn, scale, matrix, shown or opacity");
    for (const char* opacity : {"-0.1", "1.5", "nan", "true"})
        EXPECT_EQ(error_of(first + second + "opacity = " + opacity + "\n"),
                  ": object 2: opacity: expected a number from 0 to 1");
    EXPECT_EQ(error_of("[[object]]\ninput = \"scan\"\n"),
              ": object 1: has no package; 'vantage prepare' makes packages of a scene's inputs");
    const std::string no_input =
        ": object 1: has no input, expected input (a folder), or mesh, cameras and photos, or points, alone "
        "or with cameras and photos";
    EXPECT_EQ(error_of("[[object]]\npoints = \"a.ply\"\nphotos = \"p\"\n", SceneUse::prepare), no_input);
    EXPECT_EQ(error_of("[[object]]\npoints = []\n", SceneUse::prepare), no_input);
    EXPECT_EQ(error_of("[[object]]\npoints = \"a.ply\"\n"),
              ": object 1: has no package; 'vantage prepare' makes packages of a scene's inputs");
    EXPECT_EQ(error_of(first, SceneUse::prepare), no_input);
    EXPECT_EQ(error_of("[[object]]\nmesh = \"a\"\ncameras = \"b\"\n", SceneUse::prepare), no_input);
    EXPECT_EQ(error_of("[[object]]\ninput = \"a\"\npoints = [1]\n", SceneUse::prepare),
              ": object 1: points: expected files, such as [\"a.ply\"]");
    EXPECT_EQ(error_of(first + "name = \"../a\"\n"), ": object 1: name: '../a' cannot be the name of a file");
    EXPECT_EQ(error_of(first + first), ": two objects are called a");
    EXPECT_EQ(error_of(first + "name = \n").substr(0, 3), ":3:");
}
