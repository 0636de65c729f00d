// Cameras and meshes of real scans in different export conventions. The conventions must be identified from
// the photos.
#include "pipeline/align/conventions.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <functional>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "base/text/error.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/photos/image_files.h"
#include "pipeline/photos/photos.h"
#include "pipeline/photos/reduced.h"
#include "tests/datasets.h"
#include "tests/temporary_folder.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr const char* scans[] = {"sceaux-small", "fountain-P11"};

/// A matrix that exchanges and flips axes, implemented independently of the program.
Matrix3d axes(int x, int y, int z) {
    Matrix3d m = Matrix3d::Zero();
    int row = 0;
    for (const int a : {x, y, z}) m(row++, std::abs(a) - 1) = a > 0 ? 1 : -1;
    return m;
}

/// Rotates the mesh by `R` and leaves the cameras unchanged.
void turn_mesh(SceneInput& scene, const Matrix3d& R) {
    for (Vector3d& p : scene.mesh.positions) p = R * p;
}

/// The agreement of the second-best convention, as a fraction of the best.
double margin(std::vector<ConventionTrial> trials) {
    if (trials.size() < 2) return 0;  // the first pair of photos was decisive
    std::ranges::sort(trials, std::greater{}, &ConventionTrial::agreement);
    return trials[1].agreement / trials[0].agreement;
}

struct Change {
    const char* undone_by;
    std::function<void(SceneInput&)> apply;
};

const Similarity chunk{
    Eigen::AngleAxisd(2.1, Vector3d(1, -2, 0.5).normalized()).toRotationMatrix(), {30, -400, 7}, 3.7};

/// The reader has applied the transform in the camera file to the cameras, but the mesh was exported without
/// this transform.
void export_before_transform(SceneInput& scene) {
    scene.transform = chunk;
    for (PhotoInput& p : scene.photos)
        p.camera.cam_from_world = {p.camera.cam_from_world.R * chunk.R.transpose(),
                                   chunk.scale * p.camera.cam_from_world.t -
                                       p.camera.cam_from_world.R * chunk.R.transpose() * chunk.t};
}

const Change changes[] = {{"as-read", [](SceneInput&) {}},
                          {"mesh-turned", [](SceneInput& s) { turn_mesh(s, axes(1, -2, -3)); }},
                          {"mesh-y-up", [](SceneInput& s) { turn_mesh(s, axes(1, 3, -2)); }},
                          {"mesh-z-up", [](SceneInput& s) { turn_mesh(s, axes(1, -3, 2)); }},
                          {"mesh-xy-swapped", [](SceneInput& s) { turn_mesh(s, axes(2, 1, -3)); }},
                          {"no-transform", export_before_transform},
                          {"no-transform,mesh-turned",
                           [](SceneInput& s) { export_before_transform(s), turn_mesh(s, axes(1, -2, -3)); }},
                          {"camera-y-up",
                           [](SceneInput& s) {
                               for (PhotoInput& p : s.photos) {
                                   Pose& q = p.camera.cam_from_world;
                                   q = {axes(1, -2, -3) * q.R, axes(1, -2, -3) * q.t};
                               }
                           }},
                          {"transposed", [](SceneInput& s) {
                               for (PhotoInput& p : s.photos) {
                                   Pose& q = p.camera.cam_from_world;
                                   const Vector3d center = q.center();
                                   q = {q.R.transpose(), -(q.R.transpose() * center)};
                               }
                           }}};

/// A vertex in the camera's frame. It does not change if camera and mesh are rotated together.
Vector3d seen(const SceneInput& scene, std::size_t photo, std::size_t vertex) {
    const Pose& q = scene.photos[photo].camera.cam_from_world;
    return q.R * scene.mesh.positions[vertex] + q.t;
}

}  // namespace

TEST(ConventionsAtLength, EveryWrongOneIsRejectedAndTheRightOneTaken) {
    for (const char* name : scans) {
        VANTAGE_DATASET(scan, name);
        const SceneInput right = read_scene(discover(scan));
        for (const Change& change : changes) {
            SceneInput scene = right;
            change.apply(scene);
            const ConventionTrials trials = settle_convention(scene, convention_auto, 0);
            EXPECT_EQ(scene.convention, change.undone_by) << name;
            EXPECT_EQ(scene.warnings.size() == right.warnings.size(), scene.convention == as_read) << name;
            for (std::size_t i = 0; i < scene.photos.size(); ++i)
                EXPECT_LT((seen(scene, i, 7) - seen(right, i, 7)).norm(), 1e-9 * seen(right, i, 7).norm())
                    << name << ", " << change.undone_by << ", photo " << i;
            EXPECT_LT(margin(trials.cameras), 0.25) << name << ", " << change.undone_by;
            EXPECT_LT(margin(trials.mesh), 0.25) << name << ", " << change.undone_by;
            RecordProperty(
                std::string(name) + " " + change.undone_by + " margins",
                std::to_string(margin(trials.cameras)) + " " + std::to_string(margin(trials.mesh)));
        }
    }
}

TEST(Conventions, AMeshThatFitsNowhereStopsTheRun) {
    VANTAGE_DATASET(scan, "sceaux-small");
    const SceneInput right = read_scene(discover(scan));
    const auto expect_misfit = [&](const std::function<Vector3d(const Vector3d&)>& change, double px) {
        SceneInput scene = right;
        for (Vector3d& p : scene.mesh.positions) p = change(p);
        try {
            settle_convention(scene, convention_auto, 0);
            ADD_FAILURE() << "taken: " << scene.convention;
        } catch (const Error& e) {
            EXPECT_EQ(e.code(), Exit::misplaced);
            const std::string what = e.what();
            const std::size_t at = what.find("project ");
            ASSERT_NE(at, what.npos) << what;
            EXPECT_GT(std::stod(what.substr(at + 8)), px) << what;
            EXPECT_EQ(what.find('\n'), what.npos);
        }
        scene.warnings = right.warnings;
        settle_convention(scene, as_read, 0);
        EXPECT_TRUE(scene.warnings == right.warnings);
    };
    Eigen::AlignedBox3d box;
    for (const Vector3d& p : right.mesh.positions) box.extend(p);
    const Vector3d middle = box.center();
    expect_misfit([&](const Vector3d& p) -> Vector3d { return middle + 1.3 * (p - middle); }, 3);
    expect_misfit(
        [&](const Vector3d& p) -> Vector3d {
            return middle + Eigen::AngleAxisd(0.5, Vector3d(1, 1, 1).normalized()) * (p - middle);
        },
        3);
}

TEST(Conventions, AMeshBesideWhatPhotosShowStopsTheRun) {
    VANTAGE_DATASET(scan, "sceaux-small");
    const SceneInput right = read_scene(discover(scan));
    Eigen::AlignedBox3d box;
    for (const Vector3d& p : right.mesh.positions) box.extend(p);
    Vector3d eye = Vector3d::Zero();
    for (const PhotoInput& p : right.photos)
        eye += p.camera.cam_from_world.center() / double(right.photos.size());
    // The mesh is scaled to another unit, about the cameras' target or about zero, or it is moved toward the
    // cameras or sideways.
    const std::function<Vector3d(const Vector3d&)> changes[] = {
        [&](const Vector3d& p) -> Vector3d { return box.center() + 0.1 * (p - box.center()); },
        [&](const Vector3d& p) -> Vector3d { return box.center() + 0.001 * (p - box.center()); },
        [&](const Vector3d& p) -> Vector3d { return 1000 * p; },
        [&](const Vector3d& p) -> Vector3d { return p + 0.6 * (eye - box.center()); },
        [&](const Vector3d& p) -> Vector3d { return p + Vector3d(0, 0, 0.7 * box.diagonal().norm()); },
        [&](const Vector3d& p) -> Vector3d { return p + 100 * (eye - box.center()); }};
    for (const auto& change : changes) {
        SceneInput scene = right;
        for (Vector3d& p : scene.mesh.positions) p = change(p);
        EXPECT_THROW(settle_convention(scene, convention_auto, 0), Error) << &change - changes;
    }
}

TEST(Conventions, AMirroredReliefStopsTheRun) {
    VANTAGE_DATASET(scan, "fountain-P11");
    SceneInput scene = read_scene(discover(scan));
    turn_mesh(scene, axes(1, 2, -3));
    EXPECT_THROW(settle_convention(scene, convention_auto, 0), Error);
}

TEST(Conventions, AMeshThatIsSlightlyMovedIsSaid) {
    VANTAGE_DATASET(scan, "sceaux-small");
    SceneInput scene = read_scene(discover(scan));
    settle_convention(scene, convention_auto, 0);
    EXPECT_TRUE(scene.warnings.empty());
    for (Vector3d& p : scene.mesh.positions) p.x() += 0.6;  // of 10
    settle_convention(scene, convention_auto, 0);
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_NE(scene.warnings[0].find("mesh.ply: shows features"), std::string::npos) << scene.warnings[0];
}

/// Two photos from nearly the same position agree with a mesh at any distance.
TEST(Conventions, PhotosOfABurstDoNotJudgeAMesh) {
    VANTAGE_DATASET(scan, "sceaux-small");
    SceneInput scene = read_scene(discover(scan));
    PhotoInput again = scene.photos[0];
    again.camera.cam_from_world.t += Vector3d(0.002, 0, 0);
    scene.photos.insert(scene.photos.begin(), again);
    for (Vector3d& p : scene.mesh.positions) p *= 100;
    EXPECT_THROW(settle_convention(scene, convention_auto, 0), Error);
    scene.photos.resize(2);
    EXPECT_EQ(fit_of(settle_convention(scene, convention_auto, 0), scene).substr(0, 10), "not judged");
}

TEST(Conventions, ASmallPartOfWhatPhotosShowFits) {
    VANTAGE_DATASET(scan, "sceaux-small");
    SceneInput scene = read_scene(discover(scan));
    Eigen::AlignedBox3d box;
    for (const Vector3d& p : scene.mesh.positions) box.extend(p);
    std::erase_if(scene.mesh.triangles, [&](const auto& t) {
        return (scene.mesh.positions[t[0]] - box.center()).norm() > 0.15 * box.diagonal().norm();
    });
    settle_convention(scene, convention_auto, 0);
    EXPECT_EQ(scene.convention, as_read);
}

TEST(Conventions, WithoutEnoughFeaturesCamerasAreTakenAsRead) {
    VANTAGE_DATASET(scan, "sceaux-small");
    SceneInput scene = read_scene(discover(scan));
    turn_mesh(scene, axes(1, -2, -3));
    scene.photos.resize(1);
    const ConventionTrials trials = settle_convention(scene, convention_auto, 0);
    EXPECT_EQ(scene.convention, as_read);
    EXPECT_EQ(fit_of(trials, scene), "not judged: there is only one photo");
}

TEST(Conventions, CamerasThatDoNotAgreeWithPhotosAreSaid) {
    VANTAGE_DATASET(scan, "sceaux-small");
    const SceneInput right = read_scene(discover(scan));
    const auto exchanged = [&](std::size_t count) {
        SceneInput scene = right;
        scene.photos.resize(count);
        for (std::size_t i = 0; i < count; ++i) scene.photos[i].file = right.photos[count - 1 - i].file;
        return scene;
    };
    const std::string said = "cameras and photos do not agree";
    SceneInput few = exchanged(4);  // too few features agree to validate the mesh
    settle_convention(few, convention_auto, 0);
    ASSERT_EQ(few.warnings.size(), right.warnings.size() + 1);
    EXPECT_NE(few.warnings.back().find(said), said.npos) << few.warnings.back();
    SceneInput all = exchanged(right.photos.size());
    try {
        settle_convention(all, convention_auto, 0);
        ADD_FAILURE() << "taken";
    } catch (const Error& e) {
        EXPECT_NE(std::string(e.what()).find(said), said.npos) << e.what();
    }
}

TEST(Conventions, NamesOfNoConventionAreRefused) {
    EXPECT_THROW(wanted_conventions({"mesh-upside-down"}), Error);
    EXPECT_THROW(wanted_conventions({"auto", "mesh-turned"}), Error);
    EXPECT_EQ(wanted_conventions({"no-transform", "mesh-turned"}), "no-transform,mesh-turned");
}

/// Photos taken with a lens that has tangential distortion.
class TangentialPhotos : public TemporaryFolder {
  protected:
    /// Reduces the photos to 1000 px and distorts them with OpenCV's p1 and p2.
    void distort_photos(SceneInput& scene, double p1, double p2) const {
        for (PhotoInput& p : scene.photos) {
            Intrinsics& k = p.camera.intrinsics;
            const Level size = thumbnail_size(k.width, k.height, 1000);
            RgbaImage image = reduced(read_photo(p.file, {k.width, k.height}), size);
            k = k.scaled(size.width, size.height);
            const cv::Mat from(k.height, k.width, CV_8UC4, image.rgba.data());
            cv::Mat to;
            cv::remap(from, to, pinhole_pixels(k, {0, 0, p1, p2}), {}, cv::INTER_CUBIC, cv::BORDER_REPLICATE);
            p.file = dir / (p.name + ".png");
            image_files().write(p.file, k.width, k.height, 4, Sample::u8,
                                {reinterpret_cast<const std::byte*>(to.data), to.total() * 4});
            p.camera.lens = {LensModel::opencv, {0, 0, p1, p2}};
        }
    }

  private:
    /// For each pixel of the distorted photo, its position in the pinhole photo. As in OpenCV, pixel centers
    /// are at integers.
    static cv::Mat pinhole_pixels(const Intrinsics& k, const std::vector<double>& lens) {
        std::vector<cv::Point2f> all, out;
        for (int y = 0; y < k.height; ++y)
            for (int x = 0; x < k.width; ++x) all.emplace_back(float(x), float(y));
        const cv::Mat camera = (cv::Mat_<double>(3, 3) << k.fx, 0, k.cx - 0.5, 0, k.fy, k.cy - 0.5, 0, 0, 1);
        cv::undistortPoints(all, out, camera, lens, cv::noArray(), camera);
        return cv::Mat(out, true).reshape(2, k.height);
    }
};

using TangentialPhotosAtLength = TangentialPhotos;
TEST_F(TangentialPhotosAtLength, TellWhichCoefficientIsWhich) {
    for (const char* name : scans) {
        VANTAGE_DATASET(scan, name);
        SceneInput right = read_scene(discover(scan));
        distort_photos(right, 0.008, -0.005);
        const ConventionTrials trials = try_conventions(right);
        EXPECT_EQ(trials.chosen, as_read) << name;
        SceneInput scene = right;
        for (PhotoInput& p : scene.photos) std::swap(p.camera.lens.p[2], p.camera.lens.p[3]);
        settle_convention(scene, convention_auto, 0);
        EXPECT_EQ(scene.convention, "swapped-tangential") << name;
        EXPECT_EQ(scene.photos[0].camera.lens.p, right.photos[0].camera.lens.p) << name;
        for (const auto& t : trials.cameras)
            RecordProperty(std::string(name) + " " + t.names, std::to_string(t.agreement));
    }
}

}  // namespace vantage
