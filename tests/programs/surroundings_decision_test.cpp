// Which scenes get surroundings, decided by prepare with its defaults.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/prepare/finish.h"
#include "pipeline/prepare/prepare.h"
#include "pipeline/run/progress.h"
#include "pipeline/synth/garden.h"
#include "pipeline/synth/model_builder.h"
#include "pipeline/synth/synthesize.h"
#include "scene/package_reader.h"
#include "tests/datasets.h"
#include "tests/made_scenes.h"
#include "tests/programs/scan_of_model.h"
#include "tests/temporary_folder.h"

using namespace vantage;
using Eigen::Vector3d;

namespace {

using std::numbers::pi;

Camera camera_at(const Vector3d& eye, const Vector3d& target) {
    Camera c;
    c.intrinsics = {480, 360, 380, 380, 240, 180};
    c.cam_from_world = look_at(eye, target);
    return c;
}

class SurroundingsDecision : public TemporaryFolder {
  protected:
    /// The folder of a scan of this model.
    std::filesystem::path scan_of(const SynthModel& model, const std::vector<Camera>& cameras,
                                  const BesideModel& beside = {}) const {
        write_scan(dir / "scene", model, cameras, beside);
        return dir / "scene";
    }
    EffectDecision decided(const std::filesystem::path& folder, const PrepareSettings& settings = {}) const {
        const PrepareResult result =
            prepare(read_scene(discover(folder)), settings, dir / "scene.vantage", [](const Progress&) {});
        const EffectDecision decision = result.agreement->surroundings;
        EXPECT_EQ(effect_on(PackageReader(dir / "scene.vantage").scene(), Effect::surroundings), decision.on);
        return decision;
    }
};
class SurroundingsDecisionAtLength : public SurroundingsDecision {};

PrepareSettings small_photos() {
    PrepareSettings s;
    s.photo_size = 768;
    return s;
}

/// A plinth, on a table as large as it.
SynthModel object() {
    ModelBuilder b{{}, 0};
    b.box({0, 0, 0.5}, {0.4, 0.3, 0.5}, Material::marble);
    b.box({0, 0, 1.2}, {0.2, 0.25, 0.2}, Material::brick);
    return std::move(b.model);
}

/// Half around it.
std::vector<Camera> around_object() {
    std::vector<Camera> cameras;
    for (int i = 0; i < 9; ++i)
        cameras.push_back(camera_at({3 * std::sin(i * pi / 8), -3 * std::cos(i * pi / 8), 1.5}, {0, 0, 0.7}));
    return cameras;
}

}  // namespace

TEST_F(SurroundingsDecision, AFacadeInAGardenHasThem) {
    SynthSpec spec = spec_named("small");
    spec.garden = {.radius = 30, .hill = 8, .railing = 0};
    spec.object.triangles = 4000;
    spec.photos.width = 480, spec.photos.height = 360, spec.photos.samples = 1, spec.photos.fov = 70;
    copy_scene(spec, dir / "scene");
    const EffectDecision d = decided(dir / "scene");
    EXPECT_TRUE(d.on);
    EXPECT_NE(d.evidence.find("over a plain color"), std::string::npos) << d.evidence;
}

TEST_F(SurroundingsDecisionAtLength, ACastleUnderItsSkyHasThem) {
    VANTAGE_DATASET(sceaux, "sceaux");
    const EffectDecision d = decided(sceaux, small_photos());
    EXPECT_TRUE(d.on) << d.evidence;
    ASSERT_TRUE(d.judgment);
    EXPECT_GT(d.judgment->gain, 3) << d.evidence;
}

TEST_F(SurroundingsDecisionAtLength, AWallBesideAYardHasThemThoughMostPhotosShowLittleOfIt) {
    VANTAGE_DATASET(fountain, "fountain-P11");
    const EffectDecision d = decided(fountain, small_photos());
    EXPECT_TRUE(d.on) << d.evidence;
}

TEST_F(SurroundingsDecision, AFacadeThatFillsThePhotosHasNone) {
    ModelBuilder b{{}, 0};
    b.quad({-20, 0, -10}, {40, 0, 0}, {0, 0, 30}, Material::brick);
    std::vector<Camera> cameras;
    for (int i = 0; i < 6; ++i) cameras.push_back(camera_at({i - 2.5, -8, 1.7}, {i - 2.5, 0, 3}));
    const EffectDecision d = decided(scan_of(b.model, cameras));
    EXPECT_FALSE(d.on);
    EXPECT_NE(d.evidence.find("leaves 0.0 % of the photos open"), std::string::npos) << d.evidence;
}

TEST_F(SurroundingsDecision, ARoomAroundTheCamerasHasNone) {
    ModelBuilder b{{}, 0};
    const Vector3d x(6, 0, 0), y(0, 5, 0), z(0, 0, 3), corner(-3, -2.5, 0);
    b.quad(corner, x, y, Material::paving);
    b.quad(corner + z, y, x, Material::plaster);
    b.quad(corner, z, x, Material::brick);
    b.quad(corner + y, x, z, Material::text);
    b.quad(corner, y, z, Material::grating);
    b.quad(corner + x, z, y, Material::window);
    std::vector<Camera> cameras;
    for (int i = 0; i < 8; ++i) {
        const Vector3d out(std::cos(pi * i / 4), std::sin(pi * i / 4), 0);
        cameras.push_back(camera_at(Vector3d(0, 0, 1.6) - 0.8 * out, Vector3d(0, 0, 1.5) + out));
    }
    const EffectDecision d = decided(scan_of(b.model, cameras));
    EXPECT_FALSE(d.on);
    EXPECT_NE(d.evidence.find("leaves 0.0 % of the photos open"), std::string::npos) << d.evidence;
}

TEST_F(SurroundingsDecision, AnObjectOnATurntableHasNone) {
    const auto studio = [](int x, int y) {
        const auto wave = [](double v) { return std::uint8_t(128 + 60 * std::sin(v)); };
        return std::array{wave(x * 0.05), wave(y * 0.07), wave(0.04 * (x + y))};
    };
    const EffectDecision turntable = decided(scan_of(object(), around_object(), studio));
    EXPECT_FALSE(turntable.on);
    EXPECT_NE(turntable.evidence.find("moves with the camera"), std::string::npos) << turntable.evidence;
}

TEST_F(SurroundingsDecisionAtLength, AnObjectBeforePlainPaperHasNone) {
    const auto paper = [](int x, int y) {
        const auto gray = std::uint8_t(205 + (x * 7 + y * 13) % 3);
        return std::array{gray, gray, gray};
    };
    const EffectDecision d = decided(scan_of(object(), around_object(), paper));
    EXPECT_FALSE(d.on);
    EXPECT_NE(d.evidence.find("the background is plain"), std::string::npos) << d.evidence;
}
