// Tests the up direction, first view and background that prepare chooses by default for five kinds of scans.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/prepare/finish.h"
#include "pipeline/prepare/prepare.h"
#include "pipeline/run/until_stopped.h"
#include "player/view/navigation.h"
#include "scene/package/package_reader.h"
#include "tests/datasets.h"
#include "tests/made_scenes.h"
#include "tests/programs/scanned_places.h"
#include "tests/temporary_folder.h"

using namespace vantage;
using Eigen::Vector3d;

namespace {

using std::numbers::pi;

class KindsOfScan : public TemporaryFolder {
  protected:
    Agreement prepared(const std::filesystem::path& folder, const PrepareSettings& settings = {}) {
        const PrepareResult result =
            prepare(read_scene(discover(folder)), settings, dir / "scene.vantage", [](const Progress&) {});
        package.emplace(dir / "scene.vantage");
        EXPECT_EQ(effect_on(package->scene(), Effect::background), result.agreement->background.on);
        return *result.agreement;
    }
    Agreement prepared(const places::Place& place) {
        places::write(dir / "scan", place);
        const Agreement out = prepared(dir / "scan");
        EXPECT_LT(degrees_off(Vector3d::UnitZ()), 0.5);
        return out;
    }
    double degrees_off(const Vector3d& up) const {
        return std::acos(std::clamp(up_of(package->scene()).dot(up), -1.0, 1.0)) * 180 / pi;
    }
    /// The extent of a box in the first view, in units of half of a square frame; 1 means that the box
    /// reaches the frame's edges.
    Eigen::Vector2d reach(const Vector3d& low, const Vector3d& high) const {
        const View view = view_of(first_view(*package, 0), 1000, 1000, {0, 0, 1000, 1000});
        const Eigen::Map<const Vector3d> origin(package->scene().origin);
        Eigen::AlignedBox2d box;
        for (int i = 0; i < 8; ++i) {
            const Vector3d corner(i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(),
                                  i & 4 ? high.z() : low.z());
            const Vector3d at = view.cam_from_origin.R * (corner - origin) + view.cam_from_origin.t;
            EXPECT_GT(at.z(), 0);
            box.extend(Eigen::Vector2d(at.x() / at.z() * view.intrinsics.fx / 500,
                                       at.y() / at.z() * view.intrinsics.fy / 500));
        }
        EXPECT_LT(box.center().norm(), 0.2) << "centered";
        return box.sizes() / 2;
    }
    std::optional<PackageReader> package;
};
class KindsOfScanAtLength : public KindsOfScan {};

PrepareSettings small_photos() {
    PrepareSettings s;
    s.photo_size = 768;
    return s;
}

}  // namespace

TEST_F(KindsOfScanAtLength, AnObjectThatWasMovedBetweenSeriesIsShownUprightWithoutBackground) {
    const Agreement a = prepared(places::moved_object());
    EXPECT_EQ(a.presentation.kind, KindOfScan::object);
    EXPECT_FALSE(a.background.on) << a.background.evidence;
    const double fills = reach({-0.2, -0.15, 0}, {0.2, 0.15, 0.7}).maxCoeff();
    EXPECT_GT(fills, 0.6);
    EXPECT_LT(fills, 0.9);
    const auto& shade = package->scene().shade;
    EXPECT_GT(shade[0], 0.01) << "the walls' color";
    EXPECT_LT(shade[0], 0.9);
}

TEST_F(KindsOfScanAtLength, AnObjectOnATurntableHasNoBackground) {
    const Agreement a = prepared(places::turned_object());
    EXPECT_EQ(a.presentation.kind, KindOfScan::object);
    EXPECT_FALSE(a.background.on) << a.background.evidence;
}

TEST_F(KindsOfScan, AnObjectHalfAroundBeforeStudioPaperHasNone) {
    const places::Place place = places::turned_object();
    for (const bool plain : {true, false}) {
        const auto studio = [&](int x, int y) {
            const auto wave = [&](double v) { return std::uint8_t(128 + (plain ? 1 : 60) * std::sin(v)); };
            return std::array{wave(x * 0.05), wave(y * 0.07), wave(0.04 * (x + y))};
        };
        write_scan(dir / "scan", place.mesh, places::ring(9, 1.5, 0.6, 0.8, {0, 0, 0.35}, 0, pi), studio);
        const Agreement a = prepared(dir / "scan");
        EXPECT_FALSE(a.background.on);
        EXPECT_NE(a.background.evidence.find(plain ? "is plain" : "moves with the camera"), std::string::npos)
            << a.background.evidence;
    }
}

TEST_F(KindsOfScanAtLength, AMonumentInAGardenHasItsGarden) {
    const Agreement a = prepared(places::monument());
    EXPECT_EQ(a.presentation.kind, KindOfScan::object);
    EXPECT_TRUE(a.background.on) << a.background.evidence;
    EXPECT_GT(reach({-1.5, -1.2, 0}, {1.5, 1.2, 4}).maxCoeff(), 0.6);
}

TEST_F(KindsOfScan, ACourtyardIsShownFromInsideWithWhatIsBeyond) {
    const Agreement a = prepared(places::courtyard(true));
    EXPECT_EQ(a.presentation.kind, KindOfScan::inside);
    EXPECT_TRUE(a.background.on) << a.background.evidence;
    const Navigation n = first_view(*package, 0);
    EXPECT_NEAR(n.fov, 2 * std::atan(180 / 280.0) * 180 / pi, 1e-6) << "as in a photo";
}

TEST_F(KindsOfScanAtLength, AClosedCourtyardHasItsSky) {
    const Agreement a = prepared(places::courtyard(false));
    EXPECT_EQ(a.presentation.kind, KindOfScan::inside);
    EXPECT_TRUE(a.background.on) << a.background.evidence;
}

TEST_F(KindsOfScan, ARoomAroundTheCamerasHasNone) {
    places::Place room{places::built([](ModelBuilder& b) {
                           places::room(b, {-3, -2.5, 0}, {6, 5, 3});
                       }),
                       {},
                       {}};
    for (int i = 0; i < 8; ++i) {
        const Vector3d out(std::cos(pi * i / 4), std::sin(pi * i / 4), 0);
        room.cameras.push_back(places::camera_at(Vector3d(0, 0, 1.6) - 0.8 * out, Vector3d(0, 0, 1.5) + out));
    }
    const Agreement a = prepared(room);
    EXPECT_EQ(a.presentation.kind, KindOfScan::inside);
    EXPECT_FALSE(a.background.on);
    EXPECT_NE(a.background.evidence.find("does not cover 0.0 % of the photos"), std::string::npos)
        << a.background.evidence;
}

TEST_F(KindsOfScanAtLength, HousesFromTheAirOnALawnHaveNone) {
    const Agreement a = prepared(places::block(35));
    EXPECT_NE(a.presentation.kind, KindOfScan::inside);
    EXPECT_FALSE(a.background.on);
    EXPECT_NE(a.background.evidence.find("is plain"), std::string::npos) << a.background.evidence;
    EXPECT_GT(package->scene().shade[1], package->scene().shade[0]) << "the lawn's color";
}

TEST_F(KindsOfScan, AFacadeInAGardenHasItsGarden) {
    SynthSpec spec = spec_named("small");
    spec.garden = {.radius = 30, .hill = 8, .railing = 0};
    spec.object.triangles = 4000;
    spec.photos.width = 480, spec.photos.height = 360, spec.photos.samples = 1, spec.photos.fov = 70;
    copy_scene(spec, dir / "scene");
    const Agreement a = prepared(dir / "scene");
    EXPECT_EQ(a.presentation.kind, KindOfScan::front);
    EXPECT_TRUE(a.background.on);
    EXPECT_NE(a.background.evidence.find("over a plain color"), std::string::npos);
    EXPECT_LT(degrees_off(Vector3d::UnitZ()), 0.01);
}

TEST_F(KindsOfScan, AFacadeThatFillsThePhotosHasNone) {
    places::Place wall{places::built([](ModelBuilder& b) {
                           b.quad({-20, 0, -10}, {40, 0, 0}, {0, 0, 30}, Material::brick);
                       }),
                       {},
                       {}};
    for (int i = 0; i < 6; ++i)
        wall.cameras.push_back(places::camera_at({i - 2.5, -8, 1.7}, {i - 2.5, 0, 3}));
    const Agreement a = prepared(wall);
    EXPECT_FALSE(a.background.on);
    EXPECT_NE(a.background.evidence.find("does not cover 0.0 % of the photos"), std::string::npos)
        << a.background.evidence;
}

TEST_F(KindsOfScanAtLength, ACastleIsUprightUnderItsSky) {
    VANTAGE_DATASET(sceaux, "sceaux");
    const Agreement a = prepared(sceaux, small_photos());
    EXPECT_EQ(a.presentation.kind, KindOfScan::front);
    EXPECT_TRUE(a.background.on) << a.background.evidence;
    ASSERT_TRUE(a.background.judgment);
    EXPECT_GT(a.background.judgment->gain, 3) << a.background.evidence;
    EXPECT_LT(degrees_off(-Vector3d::UnitZ()), 0.5)
        << "the up direction should be exact, although all photos lean by up to 2.5 degrees";
}

TEST_F(KindsOfScanAtLength, AWallBesideAYardHasItThoughMostPhotosShowLittleOfIt) {
    VANTAGE_DATASET(fountain, "fountain-P11");
    const Agreement a = prepared(fountain, small_photos());
    EXPECT_EQ(a.presentation.kind, KindOfScan::front);
    EXPECT_TRUE(a.background.on) << a.background.evidence;
    EXPECT_LT(degrees_off(-Vector3d::UnitZ()), 0.5);
}

TEST_F(KindsOfScanAtLength, AHeadOnATableShowsItsFaceBeforeCalmGround) {
    VANTAGE_DATASET(head, "head");
    const Agreement a = prepared(head, small_photos());
    EXPECT_EQ(a.presentation.kind, KindOfScan::object);
    EXPECT_FALSE(a.background.on) << a.background.evidence;
    EXPECT_LT(degrees_off(-Vector3d::UnitY()), 12);
    // The face points toward -z and is visible in the photos of the last series.
    const std::string first = package->photos()[package->scene().first_photo].name;
    EXPECT_TRUE(first.starts_with("IMG_20161202_1548") || first.starts_with("IMG_20161202_1549")) << first;
}
