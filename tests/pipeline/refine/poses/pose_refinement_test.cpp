#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <fstream>
#include <random>

#include "base/values/quantile.h"
#include "pipeline/formats/export_colmap.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/photos/image_files.h"
#include "pipeline/prepare/finish.h"
#include "pipeline/prepare/prepare.h"
#include "pipeline/run/settings.h"
#include "pipeline/run/until_stopped.h"
#include "scene/package/package_reader.h"
#include "tests/datasets.h"
#include "tests/made_scenes.h"
#include "tests/pipeline/refine/camera_errors.h"
#include "tests/temporary_folder.h"

using namespace vantage;
namespace fs = std::filesystem;

namespace {

/// Rotates and moves each camera in random directions, which displaces points at `distance` by about `pixels`
/// in total.
void disturb(SceneInput& scene, double pixels, double distance) {
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    const auto direction = [&] {
        return Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
    };
    for (PhotoInput& p : scene.photos) {
        const double angle = pixels / p.camera.intrinsics.fx / std::sqrt(2);
        Pose& pose = p.camera.cam_from_world;
        const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, direction()).toRotationMatrix();
        pose = {turn * pose.R, turn * pose.t + direction() * angle * distance};
    }
}

double median(const std::vector<double>& v) { return quantile(v, 0.5); }
double worst(const std::vector<double>& v) { return quantile(v, 1); }

/// A synthetic scene, prepared with accurate or perturbed cameras.
class SyntheticPoseRefinement : public TemporaryFolder {
  protected:
    const fs::path scene = dir / "scene", file = dir / "scene.vantage";

    static SynthSpec spec() {
        SynthSpec s = spec_named("small");
        s.photos.count = 8;
        return s;
    }
    SceneInput truth() const { return scene_with_cameras(scene, scene / "truth" / "sparse"); }
    PrepareResult prepare_as(const SceneInput& input, EffectChoice choice = EffectChoice::automatic) const {
        PrepareSettings settings;
        if (choice != EffectChoice::automatic) settings.effects[Effect::pose_refinement] = choice;
        fs::remove(file);
        return prepare(input, settings, file, [](const Progress&) {});
    }
    PrepareResult prepare_folder(EffectChoice choice = EffectChoice::automatic) const {
        return prepare_as(scene_with_cameras(scene, scene / "sparse"), choice);
    }
    static const PoseRefinement& pose_refinement(const PrepareResult& r) {
        return r.agreement->pose_refinement;
    }
    void expect_unchanged(const SceneInput& given) const {
        const PackageReader package(file);
        EXPECT_EQ(worst(camera_errors(package, given)), 0);
        for (const auto& p : package.photos()) EXPECT_EQ(p.flags & package::photo_registered, 0u);
    }
};

class SyntheticPoseRefinementAtLength : public SyntheticPoseRefinement {};

TEST_F(SyntheticPoseRefinementAtLength, RecoversPerturbedCameras) {
    copy_scene(spec(), scene);
    constexpr double pixels = 5;
    SceneInput given = truth();
    disturb(given, pixels, 12);
    const auto done = prepare_as(given);
    EXPECT_TRUE(pose_refinement(done).decision.on) << pose_refinement(done).decision.evidence;
    const auto off = camera_errors(PackageReader(file), truth());
    // The mean of all errors remains, since it cannot be distinguished from a shift of the survey's frame.
    EXPECT_LT(median(off), 0.3 * pixels) << pose_refinement(done).decision.evidence;
    EXPECT_LT(worst(off), 0.4 * pixels);
    EXPECT_GT(median(camera_errors(PackageReader(file), given)), 0.4 * pixels);
}

TEST_F(SyntheticPoseRefinementAtLength, AccurateCamerasStayUnchanged) {
    copy_scene(spec(), scene);
    EXPECT_FALSE(pose_refinement(prepare_folder()).decision.on);
    expect_unchanged(truth());
    prepare_folder(EffectChoice::on);
    EXPECT_LT(worst(camera_errors(PackageReader(file), truth())), 0.1) << "forced on";
}

TEST_F(SyntheticPoseRefinement, PairShiftsMatchTheCameraError) {
    copy_scene(spec(), scene);
    SceneInput input = truth();
    // The camera of one photo is rotated about its vertical axis, so that the photo's content is 3 px off
    // horizontally.
    Camera& camera = input.photos[4].camera;
    camera.cam_from_world.R =
        Eigen::AngleAxisd(3 / camera.intrinsics.fx, Eigen::Vector3d::UnitY()).toRotationMatrix() *
        camera.cam_from_world.R;
    camera.cam_from_world.t =
        Eigen::AngleAxisd(3 / camera.intrinsics.fx, Eigen::Vector3d::UnitY()).toRotationMatrix() *
        camera.cam_from_world.t;
    const auto done = prepare_as(input, EffectChoice::on);
    EXPECT_GT(pose_refinement(done).decision.measured, 1);
    int with_it = 0;
    for (const package::PairRecord& p : pose_refinement(done).pairs) {
        const bool with = p.a == 4 || p.b == 4;
        with_it += with;
        // A rotation moves the edges of the picture slightly more than the center.
        EXPECT_NEAR(std::hypot(p.shift[0], p.shift[1]), with ? 3.2 : 0, with ? 0.5 : 0.2)
            << p.a << ' ' << p.b;
        EXPECT_NEAR(std::abs(p.shift[1]), 0, 0.4);
    }
    EXPECT_GE(with_it, 2);
    EXPECT_LT(worst(camera_errors(PackageReader(file), truth())), 0.5)
        << "a single wrong camera is corrected";
}

TEST_F(SyntheticPoseRefinementAtLength, SwappedCamerasAreReportedAndLeftAlone) {
    copy_scene(spec(), scene);
    SceneInput input = truth();
    std::swap(input.photos[2].camera, input.photos[5].camera);
    const auto done = prepare_as(input);
    ASSERT_EQ(pose_refinement(done).warnings.size(), 1u) << pose_refinement(done).warnings.back();
    EXPECT_NE(pose_refinement(done).warnings[0].find("cameras of 0002.jpg and 0005.jpg appear to be swapped"),
              std::string::npos)
        << pose_refinement(done).warnings[0];
    expect_unchanged(input);
}

TEST_F(SyntheticPoseRefinement, WrongCameraIsReported) {
    copy_scene(spec(), scene);
    SceneInput input = truth();
    Pose& pose = input.photos[3].camera.cam_from_world;
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.12, Eigen::Vector3d::UnitY()).toRotationMatrix();
    pose = {turn * pose.R, turn * pose.t};
    const auto done = prepare_as(input);
    ASSERT_EQ(pose_refinement(done).warnings.size(), 1u);
    EXPECT_TRUE(pose_refinement(done).warnings[0].starts_with("0003.jpg contradicts"))
        << pose_refinement(done).warnings[0];
}

/// Each case is reported in one line, and the cameras stay as given.
TEST_F(SyntheticPoseRefinementAtLength, DegenerateInputsAreReportedAndLeftAlone) {
    SynthSpec s = spec();
    s.photos.count = 4;
    copy_scene(s, scene);
    const auto expect = [&](const SceneInput& input, const std::string& reason) {
        const auto done = prepare_as(input, EffectChoice::on);
        EXPECT_FALSE(pose_refinement(done).decision.on) << reason;
        EXPECT_NE(pose_refinement(done).decision.evidence.find(reason), std::string::npos)
            << pose_refinement(done).decision.evidence;
        expect_unchanged(input);
    };
    const SceneInput whole = truth();
    SceneInput one = whole;
    one.photos.resize(1);
    expect(one, "fewer than two photos");

    SceneInput apart = whole;  // the second faces the opposite direction
    apart.photos.resize(2);
    const Eigen::Matrix3d about = Eigen::AngleAxisd(3.14159, Eigen::Vector3d::UnitY()).toRotationMatrix();
    Pose& turned = apart.photos[1].camera.cam_from_world;
    turned = {about * turned.R, about * turned.t};
    expect(apart, "no two photos see enough of the same surface");

    SceneInput other = whole;  // a different building of the same size
    s.seed = 77;
    s.building.bays = 2;
    s.building.floors = 1;
    s.object.distance = 1.7;
    copy_scene(s, dir / "other");
    other.mesh = read_scene(discover(dir / "other")).mesh;
    for (auto& p : other.mesh.positions) p = Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ()) * p;
    expect(other, "wrong mesh or wrong cameras?");

    SceneInput white = whole;
    fs::create_directories(dir / "white");
    const std::vector<std::uint8_t> pixels(std::size_t(1000 * 750 * 3), 255);
    for (PhotoInput& p : white.photos) {
        p.file = dir / "white" / p.name;
        image_files().write(p.file, 1000, 750, 3, Sample::u8, std::as_bytes(std::span(pixels)));
    }
    expect(white, "neither black nor white");
}

TEST_F(SyntheticPoseRefinement, IdenticalPhotosStayInPlace) {
    SynthSpec s = spec();
    s.photos.count = 2;
    copy_scene(s, scene);
    const SceneInput photos = truth();
    fs::copy_file(photos.photos[0].file, photos.photos[1].file, fs::copy_options::overwrite_existing);
    SceneInput input = truth();
    input.photos[1].camera = input.photos[0].camera;
    const auto done = prepare_as(input, EffectChoice::on);
    ASSERT_EQ(pose_refinement(done).pairs.size(), 1u);
    EXPECT_LT(pose_refinement(done).pairs[0].p90, 0.05f);
    EXPECT_LT(worst(camera_errors(PackageReader(file), input)), 0.02);
}

/// If the surface is flat, cameras could drift along it undetected.
TEST_F(SyntheticPoseRefinement, FlatSurfaceIsNotRegistered) {
    SynthSpec s = spec();
    s.photos.count = 3;
    s.building.recess = 0.01;
    s.error.pixels = 3;
    copy_scene(s, scene);
    SceneInput input = scene_with_cameras(scene, scene / "sparse");
    Mesh& mesh = input.mesh;
    mesh = {};
    for (const auto& [x, z] : {std::pair{-4.0, 0.5}, {4.0, 0.5}, {4.0, 6.0}, {-4.0, 6.0}})
        mesh.positions.emplace_back(x, 0.0, z);
    mesh.normals.assign(4, Eigen::Vector3f(0, -1, 0));
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    const auto done = prepare_as(input, EffectChoice::on);
    EXPECT_FALSE(pose_refinement(done).decision.on);
    EXPECT_NE(pose_refinement(done).decision.evidence.find("flat"), std::string::npos)
        << pose_refinement(done).decision.evidence;
    expect_unchanged(input);
}

/// Only pairs with changed photos are measured again, and the result is the same.
TEST_F(SyntheticPoseRefinementAtLength, ReusesPairsThatWereMeasured) {
    SynthSpec s = spec();
    s.error.pixels = 3;
    copy_scene(s, scene);
    const SceneInput input = scene_with_cameras(scene, scene / "sparse");
    prepare_as(input);
    const std::string fresh = slurp(file);
    PrepareSettings bare;
    bare.effects[Effect::exposure] = EffectChoice::on;
    const auto again = prepare(input, bare, file, [](const Progress&) {});
    for (const auto& stage : again.stages) EXPECT_EQ(stage.made, 0u);
    prepare(input, {}, file, [](const Progress&) {});
    EXPECT_TRUE(slurp(file) == fresh) << "exposure was forced on, then automatic again";

    bare.effects = {{Effect::pose_refinement, EffectChoice::off}};
    prepare(input, bare, file, [](const Progress&) {});
    expect_unchanged(input);
    prepare(input, {}, file, [](const Progress&) {});
    EXPECT_TRUE(slurp(file) == fresh) << "off and on again";
}

TEST(RealPoseRefinementAtLength, StaysOffOnAccurateScenes) {
    for (const char* name : {"sceaux", "fountain-P11"}) {
        VANTAGE_DATASET(dataset, name);
        const fs::path file = fs::temp_directory_path() / (std::string(name) + ".pose refinement.vantage");
        const auto done = prepare(read_scene(discover(dataset)), {}, file, [](const Progress&) {});
        const PoseRefinement& r = done.agreement->pose_refinement;
        EXPECT_FALSE(r.decision.on) << r.decision.evidence;
        EXPECT_TRUE(r.warnings.empty()) << r.warnings.front();
        // Dense optical flow measures 0.42 and 0.61 px.
        EXPECT_NEAR(median_displacement(r.pairs), 0.5, 0.15) << name;
        fs::remove(file);
    }
}

TEST(RealPoseRefinement, NamesAWrongFocalLength) {
    VANTAGE_DATASET(dataset, "sceaux-small");
    SceneInput input = read_scene(discover(dataset));
    for (PhotoInput& p : input.photos) p.camera.intrinsics.fx *= 1.01, p.camera.intrinsics.fy *= 1.01;
    const fs::path file = fs::temp_directory_path() / "focal.pose refinement.vantage";
    const auto done = prepare(std::move(input), {}, file, [](const Progress&) {});
    const PoseRefinement& r = done.agreement->pose_refinement;
    ASSERT_EQ(r.warnings.size(), 1u) << r.decision.evidence;
    const std::string before = "the focal length is likely ";
    const std::size_t at = r.warnings[0].find(before);
    ASSERT_NE(at, std::string::npos) << r.warnings[0];
    EXPECT_NEAR(std::stod(r.warnings[0].substr(at + before.size())), 1, 0.15) << r.warnings[0];
    EXPECT_NE(r.warnings[0].find(" % too long"), std::string::npos) << r.warnings[0];
    for (const PhotoPoseRefinement& p : r.photos) EXPECT_FALSE(p.pose);
    fs::remove(file);
}

/// Swaps the cameras of neighboring and of distant photos. No other photo may be reported, and no camera may
/// move.
TEST(RealPoseRefinementAtLength, NamesSwappedCamerasAndNoOthers) {
    for (const char* name : {"sceaux-small", "fountain-P11"}) {
        VANTAGE_DATASET(dataset, name);
        const SceneInput whole = read_scene(discover(dataset));
        const std::size_t last = whole.photos.size() - 1;
        for (const auto& [a, b] : {std::pair<std::size_t, std::size_t>{0, 1}, {1, last}}) {
            SceneInput input = whole;
            std::swap(input.photos[a].camera, input.photos[b].camera);
            const fs::path file = fs::temp_directory_path() / "swapped.pose refinement.vantage";
            PrepareSettings settings;
            settings.validate = false;
            const auto done = prepare(std::move(input), settings, file, [](const Progress&) {});
            const PoseRefinement& r = done.agreement->pose_refinement;
            const std::string both = whole.photos[a].name + " and " + whole.photos[b].name;
            EXPECT_EQ(r.warnings.size(), 1u) << name << ": " << both;
            for (const std::string& w : r.warnings)
                EXPECT_NE(w.find("cameras of " + both + " appear to be swapped"), std::string::npos)
                    << name << ": " << both << ": " << w;
            for (const PhotoPoseRefinement& p : r.photos) EXPECT_FALSE(p.pose);
            fs::remove(file);
        }
    }
}

/// Corrects cameras that are 3 px off, except for the position of the whole frame on the model, which photos
/// do not determine.
TEST(RealPoseRefinementAtLength, RecoversPerturbedCameras) {
    VANTAGE_DATASET(dataset, "fountain-P11");
    SceneInput input = read_scene(discover(dataset));
    disturb(input, 3 * std::sqrt(2), 10);
    const fs::path file = fs::temp_directory_path() / "disturbed.pose refinement.vantage";
    PrepareSettings settings;
    settings.validate = false;
    const auto done = prepare(std::move(input), settings, file, [](const Progress&) {});
    const PoseRefinement& r = done.agreement->pose_refinement;
    EXPECT_TRUE(r.decision.on) << r.decision.evidence;
    for (const PhotoPoseRefinement& p : r.photos) {
        EXPECT_TRUE(p.pose);
        EXPECT_LT(p.after, 1.3);
        EXPECT_LT(p.after, 0.5 * p.before);
    }
    fs::remove(file);
}

}  // namespace
