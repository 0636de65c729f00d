#include "pipeline/prepare/prepare.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

#include "pipeline/costs/effect_costs.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/mesh/subdivide.h"
#include "pipeline/prepare/finish.h"
#include "pipeline/reports/check.h"
#include "pipeline/run/settings.h"
#include "pipeline/run/until_stopped.h"
#include "scene/package/package_reader.h"
#include "tests/datasets.h"
#include "tests/made_scenes.h"
#include "tests/temporary_folder.h"

using namespace vantage;
namespace fs = std::filesystem;

namespace {

class Prepare : public TemporaryFolder {};
class PrepareAtLength : public Prepare {};

void quiet(const Progress&) {}

}  // namespace

TEST_F(Prepare, SceauxSmallPassesCheckAndIsDeterministic) {
    VANTAGE_DATASET(input, "sceaux-small");
    PrepareSettings settings;
    prepare(read_scene(discover(input)), settings, dir / "a.vantage", quiet);
    settings.threads = 1;
    prepare(read_scene(discover(input)), settings, dir / "b.vantage", quiet);
    EXPECT_TRUE(slurp(dir / "a.vantage") == slurp(dir / "b.vantage")) << "1 thread and all threads";
    for (const Issue& i : check_package(dir / "a.vantage", {.deep = true, .against = input}))
        ADD_FAILURE() << i.text;
}

TEST_F(Prepare, OpenGlAndProcessorAgree) {
    copy_scene(spec_named("tiny"), dir / "scene");
    for (const RenderBy by : {RenderBy::opengl, RenderBy::processor}) {
        PrepareSettings settings;
        settings.render_by = by;
        settings.distance = DistanceMethod::exact;
        prepare(read_scene(discover(dir / "scene")), settings, dir / name(by), quiet);
        for (const Issue& i : check_package(dir / name(by), {.deep = true, .against = dir / "scene"}))
            ADD_FAILURE() << name(by) << ": " << i.text;
    }
    const PackageReader a(dir / "opengl"), b(dir / "cpu");
    for (std::uint32_t p = 0; p < a.photos().size(); ++p) {
        EXPECT_NEAR(a.photos()[p].visible_vertices, b.photos()[p].visible_vertices, 1e-3);
        EXPECT_NEAR(a.photos()[p].seen_distance, b.photos()[p].seen_distance,
                    1e-3 * a.photos()[p].seen_distance);
    }
    PrepareSettings flooded;
    flooded.render_by = RenderBy::processor;
    flooded.distance = DistanceMethod::jump_flooding;
    EXPECT_THROW(prepare(read_scene(discover(dir / "scene")), flooded, dir / "none", quiet), Error);
}

TEST_F(PrepareAtLength, EveryDatasetPassesCheck) {
    for (const char* name : {"sceaux", "sceaux-bundler", "fountain-P11"}) {
        VANTAGE_DATASET(input, name);
        prepare(read_scene(discover(input)), {}, dir / "a.vantage", quiet);
        for (const Issue& i : check_package(dir / "a.vantage", {.deep = true, .against = input}))
            ADD_FAILURE() << name << ": " << i.text;
    }
}

TEST_F(Prepare, OddPhotoSizesPassCheck) {
    // Halving and rounding up changes the aspect ratio of a photo of 1062 x 797. A thumbnail with that ratio
    // would be 512 x 385, not 512 x 384.
    for (const auto& [width, height] : {std::pair(1062, 797), {797, 1062}, {513, 1}, {3, 700}}) {
        SynthSpec spec = spec_named("tiny");
        spec.photos.count = 1;
        spec.photos.samples = 1;
        spec.photos.width = width;
        spec.photos.height = height;
        const fs::path scene = dir / ("scene" + std::to_string(width));
        copy_scene(spec, scene);
        prepare(read_scene(discover(scene)), {}, dir / "a.vantage", quiet);
        for (const Issue& i : check_package(dir / "a.vantage", {.deep = true, .against = scene}))
            ADD_FAILURE() << i.text;
    }
}

TEST_F(Prepare, ReorderedVerticesKeepTheirAttributes) {
    SynthSpec spec = spec_named("tiny");
    spec.photos.count = 1;
    copy_scene(spec, dir / "scene");
    SceneInput scene = read_scene(discover(dir / "scene"));
    subdivide_large_triangles(scene.mesh, main_box(scene.mesh));  // so that prepare adds none
    const auto code = [](const Eigen::Vector3f& p) {
        return std::uint8_t(std::abs(int(p.x() * 31 + p.y() * 17 + p.z() * 7)) % 256);
    };
    VertexField height{"height", {}};
    for (const Eigen::Vector3d& p : scene.mesh.positions) {
        scene.mesh.colors.push_back({code(p.cast<float>()), 1, 2, 3});
        height.values.push_back(float(p.z()));
    }
    scene.mesh.scalars.push_back(height);
    prepare(scene, {}, dir / "a.vantage", quiet);
    const PackageReader reader(dir / "a.vantage");
    const auto positions = reader.records<Eigen::Vector3f>(package::Type::positions);
    const auto colors = reader.records<std::array<std::uint8_t, 4>>(package::Type::colors);
    const auto heights = reader.records<float>(package::Type::scalars);
    const Eigen::Map<const Eigen::Vector3d> origin(reader.scene().origin);
    ASSERT_EQ(positions.size(), scene.mesh.positions.size());
    for (std::size_t v = 0; v < positions.size(); ++v) {
        const Eigen::Vector3d p = positions[v].cast<double>() + origin;
        ASSERT_NEAR(heights[v], p.z(), 1e-5);
        ASSERT_NEAR(int(colors[v][0]), int(code(p.cast<float>())), 1);
    }
    double area = 0, before = 0;
    const auto indices = reader.records<std::uint32_t>(package::Type::indices);
    for (std::size_t t = 0; t < indices.size(); t += 3) {
        const auto at = [&](std::size_t i) { return positions[indices[t + i]].cast<double>().eval(); };
        area += (at(1) - at(0)).cross(at(2) - at(0)).norm();
    }
    for (const auto& t : scene.mesh.triangles) {
        const Eigen::Vector3d a = scene.mesh.positions[t[0]];
        before += (scene.mesh.positions[t[1]] - a).cross(scene.mesh.positions[t[2]] - a).norm();
    }
    EXPECT_NEAR(area, before, 1e-4 * before);
}

TEST_F(Prepare, PointCloudIsRejected) {
    VANTAGE_DATASET(input, "sceaux-small");
    SceneInput scene = read_scene(discover(input));
    scene.mesh.triangles.clear();
    try {
        prepare(scene, {}, dir / "a.vantage", quiet);
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), Exit::input);
        EXPECT_NE(std::string(e.what()).find("points only"), std::string::npos);
    }
    EXPECT_FALSE(fs::exists(dir / "a.vantage"));
}

TEST_F(Prepare, HeldOutPhotoKeepsOnlyItsCamera) {
    VANTAGE_DATASET(input, "sceaux-small");
    PrepareSettings settings;
    settings.hold_out = {"00003"};
    prepare(read_scene(discover(input)), settings, dir / "a.vantage", quiet);
    const PackageReader reader(dir / "a.vantage");
    const auto i = reader.photo_index("00003");
    ASSERT_TRUE(i);
    EXPECT_EQ(reader.photos()[*i].levels, 0u);
    for (const auto& e : reader.directory()) EXPECT_NE(e.photo, *i);
    EXPECT_TRUE(check_package(dir / "a.vantage", {.deep = true}).empty());
    settings.hold_out = {"nobody"};
    EXPECT_THROW(prepare(read_scene(discover(input)), settings, dir / "b.vantage", quiet), Error);
}

TEST_F(Prepare, DamageAndTruncationAreReportedForEveryChunk) {
    VANTAGE_DATASET(input, "sceaux-small");
    prepare(read_scene(discover(input)), {}, dir / "a.vantage", quiet);
    const fs::path file = dir / "a.vantage";
    std::vector<package::DirectoryEntry> entries;
    {
        const PackageReader reader(file);
        entries.assign(reader.directory().begin(), reader.directory().end());
    }
    for (const auto& e : entries) {
        if (e.length == 0) continue;
        std::fstream f(file, std::ios::in | std::ios::out | std::ios::binary);
        const auto at = std::streamoff(e.offset + e.length / 2);
        f.seekg(at);
        const char good = char(f.get());
        f.seekp(at);
        f.put(char(good ^ 0x10));
        f.close();
        const auto issues = check_package(file, {.deep = true});
        const std::string type(reinterpret_cast<const char*>(&e.type), 4);
        EXPECT_TRUE(!issues.empty() && issues[0].text.find(type) != std::string::npos)
            << type << " " << e.photo;
        std::fstream back(file, std::ios::in | std::ios::out | std::ios::binary);
        back.seekp(at);
        back.put(good);
    }
    EXPECT_TRUE(check_package(file, {.deep = true}).empty());
    for (auto e = entries.rbegin(); e != entries.rend(); ++e) {
        fs::resize_file(file, e->offset);
        const auto issues = check_package(file, {});
        ASSERT_EQ(issues.size(), 1u);
        EXPECT_EQ(issues[0].row().kind, Exit::damaged);
    }
}

/// For this scene, the threshold enables transient masks, but validation on held-out photos rejects them.
TEST_F(PrepareAtLength, WithoutTheJudgeThresholdsDecide) {
    VANTAGE_DATASET(input, "sceaux");
    PrepareSettings settings;
    settings.photo_size = 1500;
    settings.effects[Effect::pose_refinement] = EffectChoice::off;
    const auto decided = [&] {
        return prepare(read_scene(discover(input)), settings, dir / "a.vantage", quiet)
            .agreement->transients.decision;
    };
    const EffectDecision validated = decided();
    EXPECT_FALSE(validated.on) << validated.evidence;
    ASSERT_TRUE(validated.judgment);
    EXPECT_LT(validated.judgment->gain, 0);
    const auto costs = effect_costs(PackageReader(dir / "a.vantage"), {}, {});
    const auto cost_of = [&](const char* name) { return *std::ranges::find(costs, name, &EffectCost::name); };
    EXPECT_EQ(cost_of("transients").state, "off");
    EXPECT_LT(cost_of("transients").gain->mean, 0);
    EXPECT_LT(cost_of("exposure").seams, 0);
    EXPECT_EQ(cost_of("pose-refinement").state, "off, forced");
    EXPECT_GT(cost_of("exposure").bytes, 0u);
    EXPECT_FALSE(cost_of("exposure").seconds) << "the run's times are unknown";
    settings.validate = false;
    const EffectDecision by_threshold = decided();
    EXPECT_TRUE(by_threshold.on) << by_threshold.evidence;
    EXPECT_FALSE(by_threshold.judgment);
    EXPECT_EQ(by_threshold.evidence.find("held-out"), std::string::npos) << by_threshold.evidence;
    fs::remove(dir / "a.vantage");
    prepare(read_scene(discover(input)), settings, dir / "a.vantage", quiet);
    const std::string fresh = slurp(dir / "a.vantage");
    settings.validate = true;
    decided();
    settings.validate = false;
    decided();
    EXPECT_TRUE(slurp(dir / "a.vantage") == fresh) << "after a run with validation, and one without it";
}
