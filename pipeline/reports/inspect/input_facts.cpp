#include "pipeline/reports/inspect/input_facts.h"

#include <algorithm>

#include "pipeline/formats/cloud.h"
#include "pipeline/formats/meshes/read_mesh.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/prepare/prepare_plan.h"
#include "pipeline/stages/mesh_in_view.h"
#include "pipeline/visibility/geometry_renderer.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

/// Runs a step. If the step fails, its error becomes the error of the input, or a warning if the input
/// already has an error.
template <class Step>
void attempt(InputFacts& facts, const Step& step) {
    try {
        step();
    } catch (const Error& e) {
        if (!facts.error)
            facts.error = e;
        else if (std::string(facts.error->what()) != e.what())
            facts.warnings.push_back(e.what());
    }
}

void add_scene(const SceneInput& scene, InputFacts& facts) {
    facts.files = scene.files;
    if (!scene.files.mesh.empty()) facts.mesh = shape_facts(scene.mesh);
    if (!scene.points.positions.empty()) facts.points = shape_facts(scene.points);
    facts.camera_format = scene.camera_format;
    if (!scene.files.cameras.empty()) {
        std::vector<CameraSet::Entry> cameras;
        for (const PhotoInput& photo : scene.photos) cameras.push_back({photo.name, photo.camera});
        facts.cameras = camera_facts(cameras);
        facts.cameras->cameras += std::size_t(std::ranges::count_if(
            scene.skipped, [](const UnusablePhoto& photo) { return photo.why != without_camera; }));
    }
    facts.warnings = scene.warnings;
    facts.skipped = scene.skipped;
    const auto& shape = has_points_only(scene) ? facts.points : facts.mesh;
    facts.scene = {.photos = scene.photos.size(),
                   .image_sets = {},
                   .scale = shape ? scale_facts(scene, shape->diagonal()) : std::nullopt};
    for (std::uint32_t b = 0; scene.image_sets.size() > 1 && b < scene.image_sets.size(); ++b)
        facts.scene->image_sets.push_back(
            {scene.image_sets[b], std::size_t(std::ranges::count(scene.photos, b, &PhotoInput::image_set))});
}

/// Makes the same plan as the beginning of prepare().
void add_plan(SceneInput scene, const PrepareSettings& settings, const fs::path& out,
              std::chrono::steady_clock::time_point start, InputFacts& facts) {
    expect_usable(scene, settings);
    const PackedModel model = make_model(scene, settings, nullptr);
    InputFacts::Plan plan{.not_seeing = photos_not_seeing_mesh(scene), .effects = {}};
    IdentityCache identities{fs::path()};
    const PreparePlan run = make_plan(model, scene, settings, {}, identities, nullptr);
    plan.effects = run.effects;
    const std::chrono::duration<double> before = std::chrono::steady_clock::now() - start;
    plan.needs = estimate_resources(
        scene, settings, run.scene, package_layout(run.chunks, run.names),
        {.out = out, .opengl = renders_by_opengl(settings), .shares = 0, .seconds_before = before.count()});
    facts.plan = std::move(plan);
    expect_mesh_in_view(scene, facts.plan->not_seeing.size());
}

void add_cameras(InputFacts& facts) {
    std::vector<fs::path> files{facts.files.cameras};
    files.insert(files.end(), facts.files.more_cameras.begin(), facts.files.more_cameras.end());
    std::vector<CameraSet::Entry> cameras;
    for (const fs::path& file : files) {
        const CameraSet set = read_cameras(file);
        facts.camera_format = set.format;
        cameras.insert(cameras.end(), set.entries.begin(), set.entries.end());
        facts.warnings.insert(facts.warnings.end(), set.warnings.begin(), set.warnings.end());
    }
    facts.cameras = camera_facts(cameras);
}

void add_points(InputFacts& facts) {
    Mesh all;
    for (const fs::path& file : facts.files.points) {
        const Mesh cloud = read_cloud(file, facts.warnings);
        all.positions.insert(all.positions.end(), cloud.positions.begin(), cloud.positions.end());
        all.colors.insert(all.colors.end(), cloud.colors.begin(), cloud.colors.end());
    }
    facts.points = shape_facts(all);
}

/// Adds the parts of an incomplete input, reading each part separately.
void add_parts(InputFacts& facts) {
    InputFiles& files = facts.files;
    if (!files.mesh.empty())
        attempt(facts, [&] {
            facts.mesh = shape_facts(read_mesh(files.mesh, facts.warnings, &files.companions[files.mesh]));
        });
    if (!files.points.empty()) attempt(facts, [&] { add_points(facts); });
    if (!files.cameras.empty()) attempt(facts, [&] { add_cameras(facts); });
    if (facts.photos) facts.skipped = facts.photos->unreadable;
}

}  // namespace

Exit InputFacts::exit() const {
    if (error) return error->code();
    return skipped.empty() ? Exit::ok : Exit::incomplete;
}

InputFacts input_facts(const FoundInput& found, const PrepareSettings& settings, const fs::path& out,
                       std::chrono::steady_clock::time_point start) {
    InputFacts facts{.files = found.files, .error = found.lacks};
    if (!facts.error)
        attempt(facts, [&] {
            SceneInput scene = read_scene(found.files);
            add_scene(scene, facts);
            add_plan(std::move(scene), settings, out, start, facts);
        });
    if (std::error_code error; fs::is_directory(facts.files.photos, error))
        attempt(facts, [&] { facts.photos = photo_facts(facts.files.photos); });
    if (!facts.scene) add_parts(facts);
    return facts;
}

}  // namespace vantage
