#include "pipeline/prepare.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <mutex>
#include <optional>

#include "pipeline/finish_package.h"
#include "pipeline/for_each_photo.h"
#include "pipeline/known_registration.h"
#include "pipeline/needs.h"
#include "pipeline/photo_stages.h"
#include "pipeline/prepare_plan.h"
#include "pipeline/provenance.h"
#include "pipeline/registered.h"
#include "pipeline/room.h"
#include "pipeline/trace.h"
#include "scene/error.h"

namespace vantage {
namespace {

using package::Type;

/// Counts stages, and why those that were made had to be.
class Tally {
  public:
    Tally(const SceneInput& scene, nlohmann::json settings,
          const std::vector<std::unique_ptr<Former>>& formers)
        : scene_(scene), settings_(std::move(settings)), formers_(formers) {}

    void add(std::size_t i, const PhotoTables& photos, const std::vector<package::Stage>& made) {
        if (photos.states[i].left_out[0]) return;
        for (const package::Stage stage : stages_of(photos.records[i])) {
            PrepareResult::Stage& count = result.stages[std::size_t(stage)];
            if (std::ranges::count(made, stage) == 0) {
                ++count.kept;
                continue;
            }
            ++count.made;
            const std::string& photo = scene_.photos[i].name;
            count.why[why_made(stage, photo, photos.states[i], settings_, formers_)].push_back(photo);
        }
    }
    PrepareResult result;

  private:
    const SceneInput& scene_;
    nlohmann::json settings_;
    const std::vector<std::unique_ptr<Former>>& formers_;
};

void run_photos(const PhotoStages& s, PhotoTables& photos, unsigned in_flight, unsigned threads,
                const PrepareRun& run, Tally& tally, const std::function<void(const Progress&)>& progress) {
    std::mutex mutex;
    std::atomic<std::size_t> begun = 0;
    std::size_t done = 0, total = 0;
    for (std::size_t i = 0; i < photos.records.size(); ++i) total += run.share.holds(i);
    for_each_photo(photos.records.size(), in_flight, [&](std::size_t i) {
        if (!run.share.holds(i) || (run.stop && *run.stop)) return;
        const bool spare_core = threads > std::min<std::size_t>(in_flight, total - begun++);
        const auto made = run_photo(s, std::uint32_t(i), spare_core, photos.records[i], photos.states[i]);
        const std::scoped_lock lock(mutex);
        tally.add(i, photos, made);
        progress({"photos", s.scene.photos[i].name, ++done, total});
    });
    if (done < total)
        throw Error(Exit::interrupted,
                    fmt::format("stopped: {} of {} photos are done and kept; run the same again to "
                                "go on",
                                done, total));
}

/// Throws where no photo is left to show.
void note_left_out(const SceneInput& scene, const PhotoTables& photos, PrepareResult& result) {
    result.left_out = scene.left_out;
    std::size_t usable = 0;
    for (std::size_t i = 0; i < photos.records.size(); ++i)
        if (photos.states[i].left_out[0])
            result.left_out.push_back({scene.photos[i].name, photos.states[i].left_out});
        else
            ++usable;
    std::ranges::sort(result.left_out, {}, &UnusablePhoto::photo);
    if (usable == 0)
        throw Error(Exit::input, scene.files.photos.string() + ": no photo can be used; the first: " +
                                     result.left_out.front().photo + ": " + result.left_out.front().why);
}

/// Makes room, and says what it will take. Throws where there is too little of something.
Needs see_to_needs(const PreparePlan& plan, const SceneInput& scene, const PrepareSettings& settings,
                   const PrepareRun& run, bool opengl, const std::filesystem::path& out) {
    const PackageLayout layout = package_layout(plan.chunks, plan.names);
    const std::uint64_t photo = photo_memory(scene, plan.model.record);
    const std::uint64_t base = memory_now() + scene_memory(plan.model.record, opengl);
    const unsigned in_flight = photos_in_flight(settings, base, photo);
    const double share = run.share.shares ? 1.0 / run.share.shares : 1;
    const Needs needs{layout.bytes, room_for(out), base + in_flight * photo, in_flight,
                      share * expected_seconds(scene, plan.model.record, in_flight)};
    if (run.needs) run.needs(needs);
    make_room(out, layout);
    return needs;
}

/// The photos to decode while the model is prepared, as far as one gets: where nothing can be kept and memory
/// is not short.
std::vector<std::size_t> first_photos(const SceneInput& scene, const PrepareSettings& settings,
                                      const Share& share, const std::filesystem::path& out) {
    std::vector<std::size_t> first;
    if (settings.memory || std::filesystem::exists(out) || std::filesystem::exists(part_of(out)))
        return first;
    for (std::size_t i = 0; i < scene.photos.size() && first.size() < 2 * threads_of(settings); ++i)
        if (share.holds(i) && !std::ranges::count(settings.hold_out, scene.photos[i].name))
            first.push_back(i);
    return first;
}

void write_scene(PackageWriter& writer, const PreparePlan& plan, const SceneInput& scene, Trace* trace) {
    const Traced traced(trace, "write model");
    writer.write(Type::meta, package::scene_wide, std::as_bytes(std::span(plan.meta)));
    write_model(writer, plan.model, scene.mesh);
}

/// A share tells nothing of the photos together: they are described when it is merged.
void finish_share(PackageWriter& writer, const PhotoTables& photos) {
    writer.write(Type::photos, package::scene_wide, bytes_of(photos.records));
    writer.write(Type::states, package::scene_wide, bytes_of(photos.states));
    writer.finish();
}

void expect_usable(const SceneInput& scene, bool strict) {
    if (scene.mesh.points_only())
        throw Error(Exit::input,
                    scene.files.mesh.string() + ": has points only, expected a mesh with triangles");
    if (strict && !scene.left_out.empty())
        throw Error(Exit::input, scene.left_out.front().photo + ": " + scene.left_out.front().why);
}

SceneKey scene_key(const SceneInput& scene, const PrepareSettings& settings, const PackedModel& model,
                   const GeometryRenderer& renderer) {
    return {settings,
            renderer.distance(),
            renderer.by_opengl(),
            bool(model.record.effects & effect_bit(Effect::undistortion)),
            model_checksum(model, scene.mesh.normals),
            model.record.reference_density};
}

}  // namespace

PrepareResult prepare(SceneInput scene, const PrepareSettings& settings, const std::filesystem::path& out,
                      const std::function<void(const Progress&)>& progress, const PrepareRun& run) {
    expect_usable(scene, run.strict);
    if (settings.photo_size > 0) reduce_photos(scene, settings.photo_size);
    std::optional<IdentityCache> usual;
    IdentityCache& identities = run.identities ? *run.identities : usual.emplace();
    progress({"inspect", "", 0, scene.photos.size()});
    DecodedAhead ahead(scene, first_photos(scene, settings, run.share, out), threads_of(settings) - 1,
                       run.trace);
    PreparePlan plan{make_model(scene, settings, run.trace), {}, {}, {}, 0};
    const PackedModel& model = plan.model;
    GeometryRenderer renderer(model, scene.mesh.normals, settings);
    complete_plan(plan, scene, settings, run, identities);
    const Needs needs = see_to_needs(plan, scene, settings, run, renderer.by_opengl(), out);
    PackageWriter writer(out, plan.chunks, plan.names, run.share);
    const auto formers = formers_of(out, writer.resumed());
    write_scene(writer, plan, scene, run.trace);

    const SceneKey key = scene_key(scene, settings, model, renderer);
    const std::vector<Pose> given = given_poses(scene, model.origin);
    std::vector<Pose> poses = given;
    const auto known = run.share.shares
                           ? std::nullopt
                           : known_registration(key, scene, plan.photos.records, given, identities, formers);
    for (std::size_t i = 0; known && i < poses.size(); ++i)
        if (known->photos[i].pose) set_pose(poses[i] = *known->photos[i].pose, plan.photos.records[i]);
    Tally tally(scene, settings_json(settings), formers);
    const auto discs = surface_disc_set(model.positions, model.indices, model.record.reference_density);
    const GeometryStages geometry{
        model, discs, renderer, settings.border_width, settings.border_threshold, writer, run.trace};
    const PhotoStages stages{scene, key, geometry, poses, identities, ahead, formers, run.strict};
    const auto start = std::chrono::steady_clock::now();
    run_photos(stages, plan.photos, needs.in_flight, threads_of(settings), run, tally, progress);
    if (formers.empty())
        remember_speed(needs.seconds,
                       std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    note_left_out(scene, plan.photos, tally.result);
    progress({"agree", "", plan.photos.records.size(), plan.photos.records.size()});
    const Traced traced(run.trace, "finish");
    if (run.share.shares)
        finish_share(writer, plan.photos);
    else
        tally.result.agreement = std::make_shared<const Agreement>(finish_package(
            {geometry, out, plan.meta, model.record, given, known, pairs_of_formers(formers), needs.in_flight,
             until_stopped(run.stop, "stopped: all photos are done and kept; run the same again to go on",
                           progress)},
            plan.photos));
    return tally.result;
}

}  // namespace vantage
