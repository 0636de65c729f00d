#include <gtest/gtest.h>
#include <unistd.h>

#include <Eigen/LU>
#include <cstring>
#include <fstream>
#include <iomanip>

#include "datasets.h"
#include "pipeline/import/cameras.h"
#include "pipeline/import/discover.h"
#include "pipeline/import/mesh.h"
#include "pipeline/import/read_scene.h"
#include "scene/error.h"

using namespace vantage;
namespace fs = std::filesystem;

namespace {

class Import : public ::testing::Test {
  protected:
    fs::path dir = fs::temp_directory_path() / ("vantage-import-" + std::to_string(::getpid()));
    void SetUp() override { fs::create_directories(dir); }
    void TearDown() override { fs::remove_all(dir); }
    void put(const char* name, const std::string& text) {
        std::ofstream(dir / name, std::ios::binary) << text;
    }

    template <class T>
    static void append(std::string& s, T v) {
        s.append(reinterpret_cast<const char*>(&v), sizeof v);
    }
    /// One OPENCV camera and one image, in COLMAP's binary layout.
    void put_binary() {
        std::string c, i;
        append<std::uint64_t>(c, 1), append<std::uint32_t>(c, 7), append<std::int32_t>(c, 4);
        append<std::uint64_t>(c, 640), append<std::uint64_t>(c, 480);
        for (const double v : {500., 510., 320.5, 241., .1, -.02, .001, .002}) append(c, v);
        append<std::uint64_t>(i, 1), append<std::uint32_t>(i, 1);
        for (const double v : {0.9, 0.1, -0.2, 0.3, 1., 2., 3.}) append(i, v);
        append<std::uint32_t>(i, 7);
        i += std::string("a.jpg") + '\0';
        append<std::uint64_t>(i, 1), append(i, 1.), append(i, 2.), append<std::int64_t>(i, -1);
        put("cameras.bin", c), put("images.bin", i);
    }
};

const char* const cube_off =
    "OFF\n8 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
    "4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";

}  // namespace

TEST_F(Import, ColmapTextAndBinaryGiveTheSameCamera) {
    put_binary();
    const CameraSet binary = read_cameras(dir);
    fs::remove(dir / "cameras.bin");
    put("cameras.txt", "# comment\n7 OPENCV 640 480 500 510 320.5 241 0.1 -0.02 0.001 0.002\n");
    put("images.txt", "# comment\n1 0.9 0.1 -0.2 0.3 1 2 3 7 a.jpg\n\n");
    const CameraSet text = read_cameras(dir);
    ASSERT_EQ(text.entries.size(), 1u);
    ASSERT_EQ(binary.entries.size(), 1u);
    const Camera &a = text.entries[0].camera, &b = binary.entries[0].camera;
    EXPECT_EQ(text.entries[0].photo, "a.jpg");
    EXPECT_EQ(binary.entries[0].photo, "a.jpg");
    EXPECT_LT(
        (a.cam_from_world.R - b.cam_from_world.R).norm() + (a.cam_from_world.t - b.cam_from_world.t).norm(),
        1e-12);
    EXPECT_EQ(a.intrinsics.fy, b.intrinsics.fy);
    EXPECT_EQ(a.lens.p, b.lens.p);
    EXPECT_NEAR(a.cam_from_world.R.determinant(), 1, 1e-12);
}

TEST_F(Import, BundlerTurnsItsAxes) {
    // The same pose, written as Bundler would: rows 2 and 3 negated.
    put("list.txt", "images/a.jpg 0 500\nimages/b.jpg\n");
    put("b.out",
        "# Bundle file v0.3\n2 0\n500 0 0\n1 0 0\n0 -1 0\n0 0 -1\n1 -2 -3\n0 0 0\n0 0 0\n0 0 0\n0 0 0\n0 0 "
        "0\n");
    const CameraSet set = read_cameras(dir / "b.out");
    ASSERT_EQ(set.entries.size(), 1u);
    EXPECT_EQ(set.warnings.size(), 1u) << "the unregistered camera";
    EXPECT_TRUE(set.entries[0].camera.cam_from_world.R.isIdentity(1e-12));
    EXPECT_TRUE(set.entries[0].camera.cam_from_world.t.isApprox(Eigen::Vector3d(1, 2, 3)));
}

TEST_F(Import, BinaryCutAnywhereIsRefused) {
    put_binary();
    std::ifstream in(dir / "images.bin", std::ios::binary);
    const std::string whole{std::istreambuf_iterator<char>(in), {}};
    for (std::size_t n = 0; n < whole.size(); ++n) {
        put("images.bin", whole.substr(0, n));
        EXPECT_THROW(read_cameras(dir), Error) << n;
    }
}

TEST_F(Import, HugeCountsAreRefusedBeforeTheyAreUsed) {
    put_binary();
    std::string bad;
    append<std::uint64_t>(bad, 1ull << 60);
    put("images.bin", bad + std::string(100, '\1'));
    EXPECT_THROW(read_cameras(dir), Error);
}

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

TEST_F(Import, NonManifoldFacesStayAndBrokenOnesAreCounted) {
    put("fan.off", "OFF\n5 4 0\n0 0 0\n0 0 1\n1 0 0\n0 1 0\n-1 0 0\n3 0 1 2\n3 0 1 3\n3 0 1 4\n3 0 0 1\n");
    std::vector<std::string> warnings;
    EXPECT_EQ(read_mesh(dir / "fan.off", warnings).triangles.size(), 3u);
    EXPECT_EQ(warnings.size(), 1u);
}

TEST_F(Import, MissingPartsAreNamed) {
    try {
        discover(dir);
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), Exit::input);
        EXPECT_NE(std::string(e.what()).find("mesh"), std::string::npos);
    }
}

TEST(ImportReal, BundlerAndColmapAgreeOnSceaux) {
    VANTAGE_DATASET(colmap, "sceaux");
    VANTAGE_DATASET(bundler, "sceaux-bundler");
    const CameraSet a = read_cameras(colmap / "sparse"), b = read_cameras(bundler / "bundle.out");
    ASSERT_EQ(a.entries.size(), 10u);
    ASSERT_EQ(b.entries.size(), 10u);
    for (std::size_t i = 0; i < 10; ++i) {
        const Pose &p = a.entries[i].camera.cam_from_world, &q = b.entries[i].camera.cam_from_world;
        EXPECT_LT((p.R - q.R).norm(), 1e-6);
        EXPECT_LT((p.t - q.t).norm(), 1e-6);
        EXPECT_NEAR(a.entries[i].camera.intrinsics.fx, b.entries[i].camera.intrinsics.fx, 1e-4);
    }
}
