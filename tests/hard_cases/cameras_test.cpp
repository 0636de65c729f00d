// Tests invalid and nearly invalid cameras, and lenses whose distortion folds back.
#include "pipeline/formats/cameras/cameras.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>
#include <random>

#include "base/text/error.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/photos/image_files.h"
#include "scene/package/contents/pinhole_image.h"
#include "scene/package/package_reader.h"
#include "tests/hard_cases/special_numbers.h"
#include "tests/made_scenes.h"
#include "tests/temporary_folder.h"

using namespace vantage;
namespace fs = std::filesystem;

namespace {

Camera good() {
    Camera c;
    c.intrinsics = {400, 300, 350, 350, 200, 150};
    c.cam_from_world.R = Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    c.cam_from_world.t = {1, 2, 3};
    return c;
}

template <class Change>
void expect_rejected(const char* what, const Change& change) {
    Camera c = good();
    change(c);
    try {
        validate(c, "camera 7");
        ADD_FAILURE() << what << " was accepted";
    } catch (const Error& e) {
        EXPECT_TRUE(std::string(e.what()).starts_with("camera 7: ")) << e.what();
        EXPECT_EQ(e.code(), Exit::input);
    }
}

/// A photo in which each pixel's color encodes its position.
RgbaImage chart(int width, int height) {
    RgbaImage p{width, height, std::vector<std::uint8_t>(std::size_t(width) * std::size_t(height) * 4, 255)};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            std::uint8_t* at = &p.rgba[4 * (std::size_t(y) * std::size_t(width) + std::size_t(x))];
            at[0] = std::uint8_t(255 * x / width);
            at[1] = std::uint8_t(255 * y / height);
        }
    return p;
}

/// A lens and the radius at which its distortion folds back.
struct Known {
    Lens lens;
    double fold;  ///< undistorted radius at which the distortion folds back, computed in closed form
};

std::vector<Known> folding_lenses() {
    std::vector<Known> out;
    for (const double k1 : {-0.05, -0.2, -0.6}) {
        const double r = std::sqrt(-1 / (3 * k1));  // the fold of r + k1 r^3
        out.push_back({{LensModel::opencv, {k1}}, r});
        // the fold of theta + k1 theta^3, if it is in front of the camera
        out.push_back({{LensModel::fisheye, {k1}}, r < std::numbers::pi / 2 ? std::tan(r) : infinite});
        out.push_back({{LensModel::thin_prism, {k1}}, r < std::numbers::pi / 2 ? std::tan(r) : infinite});
    }
    out.push_back({{LensModel::opencv, {0, 0, 0, 0, 0, 0.3}}, 1 / std::sqrt(0.3)});  // r / (1 + 0.3 r^2)
    out.push_back({{LensModel::opencv, {0.2, 0.01}}, infinite});
    out.push_back({{LensModel::fov, {0.9}}, infinite});
    out.push_back({{LensModel::fisheye, {}}, infinite});
    return out;
}

}  // namespace

TEST(Cameras, NearlyOrthogonalRotationIsOrthonormalized) {
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    for (const double off : {1e-12, 1e-7, 1e-4}) {
        Camera c = good();
        const Eigen::Matrix3d truth = c.cam_from_world.R;
        for (int i = 0; i < 9; ++i) c.cam_from_world.R(i / 3, i % 3) += off * normal(random);
        validate(c, "camera");
        const Eigen::Matrix3d& R = c.cam_from_world.R;
        EXPECT_LT((R * R.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-14);
        EXPECT_LT((R - truth).norm(), 10 * off);
    }
    expect_rejected("a scaled rotation", [](Camera& c) { c.cam_from_world.R *= 1.01; });
    expect_rejected("no rotation", [](Camera& c) { c.cam_from_world.R.setZero(); });
    expect_rejected("a mirror", [](Camera& c) { c.cam_from_world.R.col(1) *= -1; });
}

TEST(Cameras, InvalidNumbersAreRejectedNamingTheCamera) {
    for (const double bad : {0.0, -300.0, not_a_number, infinite, -infinite}) {
        expect_rejected("fx", [&](Camera& c) { c.intrinsics.fx = bad; });
        expect_rejected("fy", [&](Camera& c) { c.intrinsics.fy = bad; });
    }
    for (const double bad : {not_a_number, infinite}) {
        expect_rejected("cx", [&](Camera& c) { c.intrinsics.cx = bad; });
        expect_rejected("R", [&](Camera& c) { c.cam_from_world.R(1, 2) = bad; });
        expect_rejected("t", [&](Camera& c) { c.cam_from_world.t.z() = bad; });
        expect_rejected("lens", [&](Camera& c) { c.lens = {LensModel::opencv, {0.1, bad}}; });
    }
    expect_rejected("width", [](Camera& c) { c.intrinsics.width = 0; });
    expect_rejected("height", [](Camera& c) { c.intrinsics.height = -3; });
}

TEST(Cameras, PrincipalPointMayLieOutsideTheFrame) {
    Camera c = good();
    c.intrinsics.cx = -900;
    c.intrinsics.cy = 5000;
    validate(c, "shifted");
    Pose pose;
    const auto p = project(c.intrinsics, pose, {3.5, -13.5, 1});
    EXPECT_NEAR(p->pixel.x(), 325, 1e-9);
    EXPECT_NEAR(p->pixel.y(), 275, 1e-9);
    const Eigen::Vector4d clip = clip_from_cam(c.intrinsics, 0.1, 10) * Eigen::Vector4d(3.5, -13.5, 1, 1);
    EXPECT_NEAR((clip.x() / clip.w() + 1) / 2 * 400, 325, 1e-9);
}

TEST(Cameras, PointsBehindOrAtInfinityAreNotInThePhoto) {
    const Camera c = good();
    const Pose& pose = c.cam_from_world;
    const Eigen::Vector3d behind = pose.center() - 2 * pose.direction();
    EXPECT_FALSE(project(c.intrinsics, pose, behind));
    EXPECT_FALSE(project(c.intrinsics, pose, pose.center()));
    EXPECT_FALSE(project(c.intrinsics, pose, {not_a_number, 0, 0}));
    EXPECT_FALSE(project(c.intrinsics, pose, {infinite, infinite, infinite}));
    const auto edge_on = project(c.intrinsics, Pose(), {1e300, 0, 1e-300});
    EXPECT_FALSE(edge_on) << "not a finite pixel";
}

TEST(Lenses, FoldAtTheRadiusOfTheClosedForm) {
    for (const Known& k : folding_lenses()) {
        const double range = lens_range(k.lens);
        if (std::isinf(k.fold)) {
            EXPECT_TRUE(std::isinf(range)) << name(k.lens.model) << ' ' << k.lens.p[0] << ": " << range;
            continue;
        }
        EXPECT_LE(range, k.fold) << name(k.lens.model);
        EXPECT_GT(std::atan(range), std::atan(k.fold) - 1e-3) << name(k.lens.model);
    }
}

TEST(Lenses, PhotoIsShownExactlyWithinTheFold) {
    for (const Known& k : folding_lenses()) {
        Camera c;
        c.intrinsics = {240, 180, 60, 60, 120, 90};  // 127 degrees wide: beyond the strong folds
        c.lens = k.lens;
        const RgbaImage out = pinhole_image(chart(240, 180), lens_table(c.intrinsics, c.lens), 0);
        int beyond = 0;
        for (int y = 0; y < 180; ++y)
            for (int x = 0; x < 240; ++x) {
                const Eigen::Vector2d ray((x + 0.5 - 120) / 60, (y + 0.5 - 90) / 60);
                const int alpha = out.rgba[4 * (std::size_t(y) * 240 + std::size_t(x)) + 3];
                if (ray.norm() > k.fold) {
                    ASSERT_EQ(alpha, 0)
                        << name(k.lens.model) << ' ' << k.lens.p[0] << " at " << x << ',' << y;
                    ++beyond;
                } else if (std::atan(ray.norm()) < std::atan(k.fold) - 2e-3) {
                    const Eigen::Vector2d d = 60 * distort(k.lens, ray) + Eigen::Vector2d(120, 90);
                    const bool inside = d.x() > 0 && d.y() > 0 && d.x() < 240 && d.y() < 180;
                    ASSERT_EQ(alpha > 0, inside) << name(k.lens.model) << " at " << x << ',' << y;
                }
            }
        EXPECT_TRUE(k.fold > 1 || beyond > 100) << "the frame should extend beyond the fold";
        const double off = largest_displacement(c);
        EXPECT_TRUE(std::isfinite(off));
    }
}

TEST(Lenses, FisheyeWiderThan180DegreesShowsWhatIsInFront) {
    Camera c;
    c.intrinsics = {200, 200, 50, 50, 100, 100};  // 229 degrees on the sensor
    c.lens.model = LensModel::fisheye;
    const RgbaImage out = pinhole_image(chart(200, 200), lens_table(c.intrinsics, c.lens), 0);
    const auto at = [&](int x, int y) { return &out.rgba[4 * (std::size_t(y) * 200 + std::size_t(x))]; };
    EXPECT_EQ(at(100, 100)[3], 255);
    // The fisheye lens images the frame's corner at this distance from the center.
    const double theta = std::atan(std::hypot(99.5, 99.5) / 50), drawn = 100 + 50 * theta / std::sqrt(2);
    EXPECT_EQ(at(199, 199)[3], 255);
    EXPECT_NEAR(at(199, 199)[0], 255 * drawn / 200, 2);
}

TEST(Lenses, ExtremeParametersGiveFiniteValues) {
    std::mt19937 random(6);
    std::normal_distribution<double> normal;
    for (int trial = 0; trial < 300; ++trial) {
        Camera c;
        c.intrinsics = {60, 40, 30, 30, 30, 20};
        c.lens.model = LensModel(1 + trial % int(last_lens_model));
        for (double& p : c.lens.p) p = std::pow(10, 3 * normal(random)) * (random() % 2 ? 1 : -1);
        const RgbaImage out = pinhole_image(chart(60, 40), lens_table(c.intrinsics, c.lens), 0);
        EXPECT_TRUE(std::isfinite(largest_displacement(c))) << trial;
        for (std::size_t i = 0; i < out.rgba.size(); i += 4)
            ASSERT_TRUE(out.rgba[i + 3] > 0 || (out.rgba[i] | out.rgba[i + 1] | out.rgba[i + 2]) == 0)
                << trial;
    }
}

namespace {

class CameraFiles : public TemporaryFolder {
  protected:
    void SetUp() override {
        TemporaryFolder::SetUp();
        SynthSpec spec = spec_named("tiny");
        spec.photos.count = 3;
        spec.photos.samples = 1;
        copy_scene(spec, dir / "scene");
    }
    /// Replaces the first line that begins with `from` in a file.
    void replace(const char* file, const std::string& from, const std::string& line) {
        const fs::path path = dir / "scene" / "sparse" / file;
        std::istringstream in(slurp(path));
        std::ofstream out(path);
        bool done = false;
        for (std::string s; std::getline(in, s);) {
            out << (!done && s.starts_with(from) ? line : s) << '\n';
            done |= s.starts_with(from);
        }
        EXPECT_TRUE(done) << from;
    }
};

}  // namespace

TEST_F(CameraFiles, PhotoWithInvalidCameraIsSkippedAndListed) {
    replace("images.txt", "2 ", "2 0 0 0 0 1 2 3 2 0001.jpg");
    const SceneInput scene = read_scene(discover(dir / "scene"));
    EXPECT_EQ(scene.photos.size(), 2u);
    ASSERT_EQ(scene.skipped.size(), 1u);
    EXPECT_EQ(scene.skipped[0].photo, "0001.jpg");
    EXPECT_NE(scene.skipped[0].why.find("not finite"), std::string::npos) << scene.skipped[0].why;
}

TEST_F(CameraFiles, OutOfRangeNumbersAreReportedInOneLine) {
    for (const char* camera : {"1 PINHOLE 400 300 1e999 1 1 1", "1 PINHOLE 99999999999 300 1 1 1 1",
                               "1 PINHOLE 400 300 x 1 1 1", "1 PINHOLE 400"}) {
        SetUp();
        replace("cameras.txt", "1 ", camera);
        try {
            const SceneInput scene = read_scene(discover(dir / "scene"));
            EXPECT_FALSE(scene.skipped.empty()) << camera;
        } catch (const Error& e) {
            EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos) << e.what();
            EXPECT_NE(std::string(e.what()).find("cameras.txt"), std::string::npos) << e.what();
        }
    }
}
