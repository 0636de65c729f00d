// Cameras from other programs.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <fstream>

#include "base/text/error.h"
#include "pipeline/formats/cameras/cameras.h"
#include "tests/datasets.h"
#include "tests/pipeline/formats/imported_files.h"

using namespace vantage;
namespace fs = std::filesystem;

TEST_F(Import, ColmapTextAndBinaryAgree) {
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

TEST_F(Import, BundlerAxesAreConverted) {
    // The same pose in Bundler's convention: rows 2 and 3 negated.
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

TEST_F(Import, BinaryTruncatedAnywhereIsRejected) {
    put_binary();
    std::ifstream in(dir / "images.bin", std::ios::binary);
    const std::string whole{std::istreambuf_iterator<char>(in), {}};
    for (std::size_t n = 0; n < whole.size(); ++n) {
        put("images.bin", whole.substr(0, n));
        EXPECT_THROW(read_cameras(dir), Error) << n;
    }
}

TEST_F(Import, HugeCountsAreRejectedBeforeAllocating) {
    put_binary();
    std::string bad;
    append<std::uint64_t>(bad, 1ull << 60);
    put("images.bin", bad + std::string(100, '\1'));
    EXPECT_THROW(read_cameras(dir), Error);
}

namespace {

void expect_same(const CameraSet& a, const CameraSet& b) {
    ASSERT_EQ(a.entries.size(), 1u);
    ASSERT_EQ(b.entries.size(), 1u);
    EXPECT_EQ(fs::path(a.entries[0].photo).filename(), fs::path(b.entries[0].photo).filename());
    const Camera &x = a.entries[0].camera, &y = b.entries[0].camera;
    EXPECT_LT((x.cam_from_world.R - y.cam_from_world.R).norm(), 1e-6);
    EXPECT_LT((x.cam_from_world.t - y.cam_from_world.t).norm(), 1e-6);
    EXPECT_NEAR(x.intrinsics.fx, y.intrinsics.fx, 1e-6);
    EXPECT_NEAR(x.intrinsics.fy, y.intrinsics.fy, 1e-6);
}

}  // namespace

TEST_F(Import, AllFormatsGiveTheSameCamera) {
    // A camera at (3, -2, 5) that looks at the origin with z up, derived from first principles.
    const Eigen::Vector3d center(3, -2, 5),
        z = -center.normalized(), x = z.cross(Eigen::Vector3d::UnitZ()).normalized(), y = z.cross(x);
    Eigen::Matrix3d R;
    R << x.transpose(), y.transpose(), z.transpose();
    const Eigen::Vector3d t = -R * center;
    const Eigen::Quaterniond q(R);
    put("cameras.txt", "1 PINHOLE 640 480 500 500 320 240\n");
    put("images.txt", "1 " + numbers({q.w(), q.x(), q.y(), q.z(), t.x(), t.y(), t.z()}) + "1 a.jpg\n\n");
    const CameraSet colmap = read_cameras(dir);
    EXPECT_NEAR(colmap.entries.at(0).camera.intrinsics.cx, 320, 1e-12);

    put("list.txt", "a.jpg\n");
    put("b.out",
        "# Bundle file v0.3\n1 0\n500 0 0\n" + numbers({R(0, 0), R(0, 1), R(0, 2)}) +
            numbers({-R(1, 0), -R(1, 1), -R(1, 2), -R(2, 0), -R(2, 1), -R(2, 2), t.x(), -t.y(), -t.z()}));
    expect_same(colmap, read_cameras(dir / "b.out"));

    put("m.mlp",
        "<!DOCTYPE MeshLabDocument>\n<MeshLabProject><MeshGroup/><RasterGroup><MLRaster label=\"a\">"
        "<VCGCamera CameraType=\"0\" LensDistortion=\"0 0\" ViewportPx=\"640 480\" PixelSizeMm=\"0.01 0.01\" "
        "FocalMm=\"5\" CenterPx=\"320 240\" TranslationVector=\"" +
            numbers({-center.x(), -center.y(), -center.z(), 1}) + "\" RotationMatrix=\"" +
            numbers({R(0, 0), R(0, 1), R(0, 2), 0, -R(1, 0), -R(1, 1), -R(1, 2), 0, -R(2, 0), -R(2, 1),
                     -R(2, 2), 0, 0, 0, 0, 1}) +
            "\"/><Plane fileName=\"images/a.jpg\"/></MLRaster></RasterGroup></MeshLabProject>\n");
    expect_same(colmap, read_cameras(dir / "m.mlp"));
    EXPECT_EQ(read_cameras(dir / "m.mlp").entries[0].camera.intrinsics.cy, 240);
}

TEST_F(Import, RealvizCamerasAreRejectedWithAReason) {
    put("a.rz3", "CREATOR REALVIZ\n");
    try {
        read_cameras(dir / "a.rz3");
        FAIL();
    } catch (const Error& e) {
        EXPECT_NE(std::string(e.what()).find("export .rzml instead"), std::string::npos);
    }
}

TEST_F(Import, IncompleteMeshLabProjectIsRejected) {
    for (const char* text :
         {"", "<MeshLabProject>", "<MeshLabProject/>",
          "<MeshLabProject><RasterGroup><MLRaster label='a'><VCGCamera FocalMm='5'/></MLRaster>"
          "</RasterGroup></MeshLabProject>"}) {
        put("m.mlp", text);
        EXPECT_THROW(read_cameras(dir / "m.mlp"), Error) << text;
    }
}

TEST(RealImport, BundlerAndColmapAgreeOnSceaux) {
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
