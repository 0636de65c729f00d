#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "pipeline/photos/photos.h"
#include "pipeline/prepare/finish.h"
#include "pipeline/prepare/prepare.h"
#include "pipeline/refine/poses/common_motion.h"
#include "pipeline/run/settings.h"
#include "pipeline/synth/building.h"
#include "tests/made_scenes.h"
#include "tests/pipeline/refine/camera_errors.h"
#include "tests/temporary_folder.h"

using namespace vantage;
namespace fs = std::filesystem;

namespace {

using Eigen::Vector3d;

/// Ten photos of a small building with exact cameras. Each test introduces one error and prints its row of
/// the table in docs/records/measurements-2026-11.md.
class PoseRefinementTruthAtLength : public TemporaryFolder {
  protected:
    const fs::path scene = dir / "scene", file = dir / "scene.vantage";
    SceneInput exact;

    static SynthSpec spec() {
        SynthSpec s = spec_named("small");
        s.photos.count = 10;
        return s;
    }
    void SetUp() override {
        TemporaryFolder::SetUp();
        copy_scene(spec(), scene);
        exact = scene_with_cameras(scene, scene / "truth" / "sparse");
    }
    /// The scene's surface, with finely subdivided walls.
    static Mesh fine_mesh() {
        SynthSpec s = spec();
        s.building.max_edge = 0.25;
        return build_model(s).mesh;
    }
    struct Registered {
        PoseRefinement pose_refinement;
        std::vector<double> moved, off;  ///< per camera: distance from the given and the true camera, px
        const std::string& evidence() const { return pose_refinement.decision.evidence; }
        bool says(const std::string& words) const { return evidence().find(words) != std::string::npos; }
        std::string warnings() const {
            std::string out;
            for (const std::string& w : pose_refinement.warnings) out += w + "\n";
            return out;
        }
        double most_moved() const { return quantile(moved, 1); }
    };
    Registered outcome(const std::string& what, const SceneInput& input,
                       EffectChoice choice = EffectChoice::automatic) const {
        PrepareSettings settings;
        if (choice != EffectChoice::automatic) settings.effects[Effect::pose_refinement] = choice;
        for (const Effect e : {Effect::exposure, Effect::vignetting, Effect::transients})
            settings.effects[e] = EffectChoice::off;
        fs::remove(file);
        const auto done = prepare(input, settings, file, [](const Progress&) {});
        const PackageReader package(file);
        Registered out{done.agreement->pose_refinement, camera_errors(package, input),
                       camera_errors(package, exact)};
        std::printf("%s: moved by at most %.2f px, then wrong by at most %.2f px; %s\n%s", what.c_str(),
                    out.most_moved(), quantile(out.off, 1), out.evidence().c_str(), out.warnings().c_str());
        return out;
    }
};

/// For each vertex, the first vertex at the same position.
std::vector<std::uint32_t> welded(const Mesh& mesh) {
    std::map<std::array<long, 3>, std::uint32_t> first;
    std::vector<std::uint32_t> out;
    for (const Vector3d& p : mesh.positions) {
        const std::array at{std::lround(p.x() * 1e4), std::lround(p.y() * 1e4), std::lround(p.z() * 1e4)};
        out.push_back(first.try_emplace(at, std::uint32_t(out.size())).first->second);
    }
    return out;
}

/// Laplacian smoothing in `times` steps: in each step, every vertex moves halfway to the mean of its
/// neighbors.
Mesh smoothed(Mesh mesh, int times) {
    const std::vector<std::uint32_t> at = welded(mesh);
    std::vector<std::set<std::uint32_t>> neighbors(at.size());
    for (const auto& t : mesh.triangles)
        for (const std::uint32_t a : t)
            for (const std::uint32_t b : t)
                if (at[a] != at[b]) neighbors[at[a]].insert(at[b]);
    for (int i = 0; i < times; ++i) {
        const auto before = mesh.positions;
        for (std::uint32_t v = 0; v < at.size(); ++v) {
            Vector3d mean = Vector3d::Zero();
            for (const std::uint32_t n : neighbors[at[v]])
                mean += before[n] / double(neighbors[at[v]].size());
            if (!neighbors[at[v]].empty()) mesh.positions[v] = (before[at[v]] + mean) / 2;
        }
    }
    return mesh;
}

/// With exact cameras, any disagreement between photos is due to the mesh.
TEST_F(PoseRefinementTruthAtLength, MeshErrorsMoveNoCamera) {
    const Mesh mesh = fine_mesh();
    Eigen::AlignedBox3d box;
    for (const Vector3d& p : mesh.positions) box.extend(p);
    const double size = box.diagonal().norm(), off = 0.003 * size;
    const auto moved = [&](const std::function<Vector3d(const Vector3d&, const Vector3d&)>& by) {
        Mesh out = mesh;
        for (std::size_t v = 0; v < mesh.positions.size(); ++v)
            out.positions[v] += by(mesh.positions[v], mesh.normals[v].cast<double>());
        return out;
    };
    const auto bulge = [&](const Vector3d& p, const Vector3d&) {
        const Vector3d from = p - box.center();
        return Vector3d(from.normalized() * off * 3 * std::exp(-std::pow(from.norm() / (0.3 * size), 2)));
    };
    const auto waves = [&](const Vector3d& p, const Vector3d&) {
        const Vector3d at = p * (40 / size);
        return Vector3d(off * Vector3d(std::sin(at.y()), std::sin(at.z()), std::sin(at.x())));
    };
    Mesh without_object = mesh;
    std::erase_if(without_object.triangles, [&](const auto& t) {
        const Vector3d& p = mesh.positions[t[0]];
        return std::abs(p.x()) < 2 && std::abs(p.y() + spec().object.distance) < 2 && p.z() > 1e-6;
    });
    ASSERT_LT(without_object.triangles.size(), mesh.triangles.size() / 2);
    const std::map<std::string, Mesh> wrong = {
        {"bulge of 0.9 %", moved(bulge)},
        {"waves of 0.3 %", moved(waves)},
        {"displaced by 0.3 % along its normals",
         moved([&](const Vector3d&, const Vector3d& n) { return Vector3d(off * n); })},
        {"displaced by 0.3 % as a whole",
         moved([&](const Vector3d&, const Vector3d&) { return Vector3d(0, off, 0); })},
        {"smoothed", smoothed(mesh, 10)},
        {"without the object", without_object}};
    for (const auto& [what, with] : wrong) {
        SceneInput input = exact;
        input.mesh = with;
        const Registered found = outcome(what, input);
        EXPECT_LE(found.most_moved(), 0.3) << what;
        EXPECT_EQ(found.warnings(), "") << what;
    }
}

/// The wrong camera is at the end of the row, where few photos overlap, or in the middle.
TEST_F(PoseRefinementTruthAtLength, OneWrongCameraReturnsAndTheOthersStay) {
    for (const std::size_t wrong : {std::size_t(0), std::size_t(4)}) {
        SceneInput input = exact;
        Camera& camera = input.photos[wrong].camera;
        Pose& pose = camera.cam_from_world;
        const Eigen::Matrix3d turn =
            Eigen::AngleAxisd(3 / camera.intrinsics.fx, Vector3d(1, 1, 0).normalized()).toRotationMatrix();
        pose = {turn * pose.R, turn * pose.t};
        const Registered found = outcome("one of ten off by 3 px", input);
        EXPECT_TRUE(found.pose_refinement.decision.on) << found.evidence();
        for (std::size_t i = 0; i < found.off.size(); ++i)
            EXPECT_LE(found.off[i], i == wrong ? 0.3 : 0.1) << i;
        EXPECT_EQ(found.warnings(), "");
    }
}

/// The cameras and the mesh are not aligned. Photos cannot reveal whether the cameras or the mesh are wrong,
/// so the frame of the survey is kept.
TEST_F(PoseRefinementTruthAtLength, CamerasOffTogetherAreFoundAndSaid) {
    const double off = 0.08;  // m away from the facade: 5 px in the median photo
    SceneInput input = exact;
    const Similarity shift{Eigen::Matrix3d::Identity(), {0, off, 0}};
    for (PhotoInput& p : input.photos) p.camera.cam_from_world = compose(p.camera.cam_from_world, shift);
    const Registered found = outcome("all off together", input);
    EXPECT_NEAR(quantile(found.off, 0.5), 5, 0.5);
    const std::string words = "all cameras together are displaced by at least ";
    ASSERT_TRUE(found.says(words)) << found.evidence();
    const double said = std::stod(found.evidence().substr(found.evidence().find(words) + words.size()));
    EXPECT_GT(said, 2);
    EXPECT_LT(said, 5.5);
    EXPECT_TRUE(found.says("moving them together")) << found.evidence();
    EXPECT_TRUE(found.says("held-out photos")) << found.evidence();
    EXPECT_EQ(found.most_moved(), 0) << found.evidence();

    const Registered nothing = outcome("nothing wrong", exact);
    EXPECT_FALSE(nothing.says("together")) << nothing.evidence();
    EXPECT_EQ(nothing.warnings(), "");
    EXPECT_EQ(nothing.most_moved(), 0);
}

/// Writes the photo that a rolling shutter takes while the camera moves sideways.
void roll(const fs::path& from, const fs::path& to, const Intrinsics& k, double pixels) {
    const RgbaImage image = read_photo(from, {k.width, k.height});
    std::vector<std::uint8_t> rgb;
    for (int y = 0; y < k.height; ++y)
        for (int x = 0; x < k.width; ++x) {
            const double at = std::clamp(x - pixels * ((y + 0.5) / k.height - 0.5), 0.0, k.width - 1.001);
            const int left = int(at);
            for (int c = 0; c < 3; ++c) {
                const auto value = [&](int column) {
                    return double(image.rgba[std::size_t((y * k.width + column) * 4 + c)]);
                };
                rgb.push_back(std::uint8_t(std::lround(std::lerp(value(left), value(left + 1), at - left))));
            }
        }
    image_files().write(to, k.width, k.height, 3, Sample::u8, std::as_bytes(std::span(rgb)));
}

/// This must hold even if pose refinement is forced, which skips leave-one-out validation.
TEST_F(PoseRefinementTruthAtLength, RollingShutterIsNamedAndNotHiddenInPoses) {
    constexpr double pixels = 3.5;
    SceneInput input = exact;
    fs::create_directories(dir / "rolled");
    for (PhotoInput& p : input.photos) {
        roll(p.file, dir / "rolled" / p.name, p.camera.intrinsics, pixels);
        p.file = dir / "rolled" / p.name;
    }
    const Registered found = outcome("rolling shutter of 3.5 px", input, EffectChoice::on);
    const std::string words = "all photos: the displacement grows from row to row, by ";
    ASSERT_TRUE(found.warnings().starts_with(words)) << found.warnings();
    EXPECT_NEAR(std::stod(found.warnings().substr(words.size())), pixels, 0.7);
    EXPECT_NE(found.warnings().find("rolling shutter?"), std::string::npos);
    EXPECT_LE(found.most_moved(), 0.3);
}

TEST_F(PoseRefinementTruthAtLength, WrongFocalLengthIsNamedAndNotHiddenInPoses) {
    const auto expect = [&](const std::string& what, const std::vector<std::size_t>& photos, double factor,
                            const std::string& name, const std::string& direction) {
        SceneInput input = exact;
        for (const std::size_t i : photos) {
            Intrinsics& k = input.photos[i].camera.intrinsics;
            k.fx *= factor, k.fy *= factor;
        }
        const Registered found = outcome(what, input, EffectChoice::on);
        ASSERT_EQ(found.pose_refinement.warnings.size(), 1u) << found.warnings();
        EXPECT_TRUE(found.warnings().starts_with(name)) << found.warnings();
        const std::string words = "the focal length is likely ";
        const std::size_t at = found.warnings().find(words);
        ASSERT_NE(at, std::string::npos) << found.warnings();
        EXPECT_NEAR(std::stod(found.warnings().substr(at + words.size())), 1, 0.15) << found.warnings();
        EXPECT_NE(found.warnings().find(direction), std::string::npos) << found.warnings();
        EXPECT_LE(found.most_moved(), 0.3);
    };
    const std::vector<std::size_t> all = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
    expect("focal length of all 1 % too long", all, 1.01, "all photos: ", "% too long");
    expect("focal length of all 1 % too short", all, 0.99, "all photos: ", "% too short");
    expect("focal length of one camera 1 % too long", {4}, 1.01, "0004.jpg: ", "% too long");
}

}  // namespace
