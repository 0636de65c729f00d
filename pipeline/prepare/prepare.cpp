#include "pipeline/prepare/prepare.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/files/checksum.h"
#include "base/files/part_file.h"
#include "base/text/error.h"
#include "base/values/bytes_of.h"
#include "pipeline/output/disk_space.h"
#include "pipeline/output/meta.h"
#include "pipeline/output/photo_records.h"
#include "pipeline/prepare/finish.h"
#include "pipeline/prepare/joined_image_sets.h"
#include "pipeline/prepare/photo/photo_stages.h"
#include "pipeline/prepare/pose_refinement_reuse.h"
#include "pipeline/prepare/prepare_plan.h"
#include "pipeline/prepare/resources.h"
#include "pipeline/run/for_each_photo.h"
#include "pipeline/stages/mesh_in_view.h"

namespace vantage {
namespace {

using package::Type;

/// Counts the stages that ran, with the reasons, and the stages whose chunks were kept.
class StageCounts {
  public:
    StageCounts(const SceneInput& scene, nlohmann::json settings, const EarlierPackages& earlier)
        : scene_(scene), settings_(std::move(settings)), earlier_(earlier) {}

    void add(std::size_t i, const PhotoTables& photos, const std::vector<package::Stage>& made) {
        if (photos.states[i].skipped[0]) return;
        for (const package::Stage stage : stages_of(photos.records[i])) {
            PrepareResult::Stage& count = result.stages[std::size_t(stage)];
            if (std::ranges::count(made, stage) == 0) {
                ++count.kept;
                continue;
            }
            ++count.made;
            const std::string& photo = scene_.photos[i].name;
            count.why[reason_to_run(stage, photo, photos.states[i], settings_, earlier_)].push_back(photo);
        }
    }
    PrepareResult result;

  private:
    const SceneInput& scene_;
    nlohmann::json settings_;
    const EarlierPackages& earlier_;
};

/// The photos to decode while the model is being prepared: none if memory is limited or chunks may be reused.
std::vector<std::size_t> photos_to_prefetch(const SceneInput& scene, const PrepareSettings& settings,
                                            const Share& share, const std::filesystem::path& out) {
    std::vector<std::size_t> first;
    if (settings.memory || std::filesystem::exists(out) || std::filesystem::exists(part_of(out)))
        return first;
    const std::vector<bool> held = held_out(scene, settings.hold_out);
    for (std::size_t i = 0; i < scene.photos.size() && first.size() < 2 * threads_of(settings); ++i)
        if (share.holds(i) && !held[i]) first.push_back(i);
    return first;
}

/// Estimates and reports the resources that the run needs. Throws if the free disk space or --memory is too
/// small.
ResourceEstimate reserve(const PreparePlan& plan, const SceneInput& scene, const PrepareSettings& settings,
                         const PrepareRun& run, bool opengl, const std::filesystem::path& out) {
    const PackageLayout layout = package_layout(plan.chunks, plan.names);
    const std::chrono::duration<double> before = std::chrono::steady_clock::now() - run.start;
    const ResourceEstimate estimate = estimate_resources(
        scene, settings, plan.scene, layout,
        {.out = out, .opengl = opengl, .shares = run.share.shares, .seconds_before = before.count()});
    if (run.on_estimate) run.on_estimate(estimate);
    ensure_disk_space(out, layout);
    return estimate;
}

void write_lenses(PackageWriter& writer, const SceneInput& scene) {
    std::vector<package::LensRecord> records;
    for (const PhotoInput& photo : scene.photos) {
        const Lens& lens = photo.camera.lens;
        records.push_back({lens.distorts() ? std::uint32_t(lens.model) : 0, 0, {}});
        std::ranges::copy(lens.p, records.back().p);
    }
    writer.write(Type::lenses, package::scene_wide, bytes_of(records));
}

void write_scene(PackageWriter& writer, const PreparePlan& plan, const PackedModel& model,
                 const SceneInput& scene, Trace* trace) {
    const Traced traced(trace, "write model");
    writer.write(Type::meta, package::scene_wide, std::as_bytes(std::span(plan.meta)));
    writer.write(Type::scene, package::scene_wide, bytes_of_one(plan.scene));
    write_model(writer, model, scene.mesh);
    write_image_sets(writer, plan.image_sets, {});
    if (effect_on(plan.scene, Effect::undistortion)) write_lenses(writer, scene);
    if (!plan.points.empty()) {
        const Traced points(trace, "points");
        write_points(writer, plan.points, scene.points, model.origin);
    }
}

/// The checksum of the model and of the points that it represents.
std::uint64_t with_cloud(std::uint64_t model, const SplatCloud& cloud) {
    const std::array all{model, checksum(bytes_of(cloud.positions)), checksum(bytes_of(cloud.radii))};
    return checksum(std::as_bytes(std::span(all)));
}

SceneKey scene_key(const PreparePlan& plan, const SceneInput& scene, const PrepareSettings& settings,
                   const PackedModel& model, const GeometryRenderer& renderer) {
    const std::uint64_t checksum_of_model = model_checksum(model, scene.mesh.normals);
    return {.settings = settings,
            .distance = renderer.distance(),
            .opengl = renderer.by_opengl(),
            .undistortion = effect_on(plan.scene, Effect::undistortion),
            .compact = effect_on(plan.scene, Effect::compact),
            .model = renderer.cloud() ? with_cloud(checksum_of_model, *renderer.cloud()) : checksum_of_model,
            .reference_density = plan.scene.reference_density};
}

void run_photos(const PhotoContext& context, PhotoTables& photos, unsigned in_flight, const PrepareRun& run,
                StageCounts& counts, const OnProgress& progress) {
    const PrepareSettings& settings = context.key.settings;
    const unsigned threads = uses_spare_cores(settings, in_flight) ? threads_of(settings) : 1;
    std::mutex mutex;
    std::atomic<std::size_t> begun = 0;
    std::size_t done = 0, total = 0;
    for (std::size_t i = 0; i < photos.records.size(); ++i) total += run.share.holds(i);
    progress({"photos", "", 0, total});
    for_each_photo(photos.records.size(), in_flight, [&](std::size_t i) {
        if (!run.share.holds(i) || (run.stop && *run.stop)) return;
        const bool spare_core = threads > std::min<std::size_t>(in_flight, total - begun++);
        const auto made =
            run_photo(context, std::uint32_t(i), spare_core, photos.records[i], photos.states[i]);
        const std::scoped_lock lock(mutex);
        counts.add(i, photos, made);
        progress({"photos", context.scene.photos[i].name, ++done, total});
    });
    if (done < total)
        throw Error(Exit::interrupted,
                    fmt::format("stopped: {} of {} photos are done and kept; run the same command again to "
                                "continue",
                                done, total));
}

/// Lists the photos that were skipped. Throws if no photo is usable.
void record_skipped(const SceneInput& scene, const PhotoTables& photos, PrepareResult& result) {
    result.skipped = scene.skipped;
    std::size_t usable = 0;
    for (std::size_t i = 0; i < photos.records.size(); ++i)
        if (photos.states[i].skipped[0])
            result.skipped.push_back({scene.photos[i].name, photos.states[i].skipped});
        else
            ++usable;
    std::ranges::sort(result.skipped, {}, &UnusablePhoto::photo);
    if (usable == 0 && !has_points_only(scene))
        throw Error(Exit::input, scene.files.photos.string() + ": no photo can be used; first problem: " +
                                     result.skipped.front().photo + ": " + result.skipped.front().why);
}

/// Finishes a shard. The results that depend on all photos are computed when the shards are merged.
void finish_share(PackageWriter& writer, const PhotoTables& photos) {
    writer.write(Type::photos, package::scene_wide, bytes_of(photos.records));
    writer.write(Type::states, package::scene_wide, bytes_of(photos.states));
    writer.finish();
}

/// The scene's cameras: the given poses, and the current ones, which an earlier run may have refined from the
/// same inputs.
struct Cameras {
    std::vector<Pose> given, current;  ///< relative to the origin
    std::optional<PoseRefinement> pose_refinement;
};

/// Determines the cameras and writes refined poses to the photos' records.
Cameras scene_cameras(const SceneKey& key, const SceneInput& scene, const Eigen::Vector3d& origin,
                      IdentityCache& identities, const EarlierPackages& earlier,
                      std::vector<package::PhotoRecord>& records) {
    Cameras cameras{.given = given_poses(scene, origin), .current = {}, .pose_refinement = {}};
    cameras.current = cameras.given;
    cameras.pose_refinement =
        earlier_pose_refinement(key, scene, records, cameras.given, identities, earlier);
    for (std::size_t i = 0; cameras.pose_refinement && i < records.size(); ++i)
        if (const auto& pose = cameras.pose_refinement->photos[i].pose) {
            cameras.current[i] = *pose;
            set_pose(*pose, records[i]);
        }
    return cameras;
}

/// Runs all stages of all photos and updates the estimate of this machine's speed.
PrepareResult prepare_photos(const PhotoContext& context, PhotoTables& photos,
                             const ResourceEstimate& estimate, const PrepareRun& run,
                             const OnProgress& progress) {
    StageCounts counts(context.scene, settings_json(context.key.settings), context.earlier);
    const auto start = std::chrono::steady_clock::now();
    run_photos(context, photos, estimate.in_flight, run, counts, progress);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    if (context.earlier.empty()) remember_speed(estimate.photo_seconds, took.count());
    record_skipped(context.scene, photos, counts.result);
    return std::move(counts.result);
}

}  // namespace

PrepareResult prepare(SceneInput scene, const PrepareSettings& settings, const std::filesystem::path& out,
                      const OnProgress& progress, const PrepareRun& run) {
    expect_usable(scene, settings);
    if (run.strict && !scene.skipped.empty())
        throw Error(Exit::input, scene.skipped.front().photo + ": " + scene.skipped.front().why);
    if (settings.photo_size > 0) reduce_photos(scene, settings.photo_size);
    std::optional<IdentityCache> default_cache;
    IdentityCache& identities = run.identities ? *run.identities : default_cache.emplace();
    progress({"inspect", "", 0, scene.photos.size()});
    PhotoPrefetch prefetch(scene, photos_to_prefetch(scene, settings, run.share, out),
                           threads_of(settings) - 1, run.trace);
    const PackedModel model = make_model(scene, settings, run.trace);
    if (run.expect_view) expect_mesh_in_view(scene, photos_not_seeing_mesh(scene).size());
    GeometryRenderer renderer(model, scene.mesh.normals, settings);
    PreparePlan plan = make_plan(model, scene, settings, run.share, identities, run.trace);
    if (!effect_on(plan.scene, Effect::scalar_fields)) scene.mesh.scalars.clear();
    SplatCloud cloud;
    if (has_points_only(scene) && !scene.photos.empty()) {
        cloud = splat_cloud(plan.points, scene.points, model.origin);
        renderer.splats(cloud);
    }
    const ResourceEstimate estimate = reserve(plan, scene, settings, run, renderer.by_opengl(), out);

    PackageWriter writer(out, plan.chunks, plan.names, run.share);
    const EarlierPackages earlier = earlier_packages(out, writer.resumed());
    write_scene(writer, plan, model, scene, run.trace);
    plan.points = {};
    scene.points = {};
    const bool share = run.share.shares > 0;
    const SceneKey key = scene_key(plan, scene, settings, model, renderer);
    const EarlierPackages none;  // a shard has no pose refinement
    const Cameras cameras =
        scene_cameras(key, scene, model.origin, identities, share ? none : earlier, plan.photos.records);
    const auto discs = surface_disc_set(model.positions, model.opaque_indices(), plan.scene.reference_density,
                                        bounds_from_origin(plan.scene));
    const GeometryContext geometry{.model = model,
                                   .discs = discs,
                                   .renderer = renderer,
                                   .reference_density = plan.scene.reference_density,
                                   .writer = writer,
                                   .trace = run.trace};
    const PhotoContext context{.scene = scene,
                               .key = key,
                               .geometry = geometry,
                               .poses = cameras.current,
                               .identities = identities,
                               .prefetch = prefetch,
                               .earlier = earlier,
                               .writer = writer,
                               .trace = run.trace,
                               .strict = run.strict};
    PrepareResult result = prepare_photos(context, plan.photos, estimate, run, progress);

    progress({"agree", "", plan.photos.records.size(), plan.photos.records.size()});
    const Traced traced(run.trace, "finish");
    if (share) {
        finish_share(writer, plan.photos);
        return result;
    }
    const FinishInput finish{
        .geometry = geometry,
        .out = out,
        .meta = plan.meta,
        .choices = settings.effects,
        .validate = settings.validate,
        .scene = plan.scene,
        .image_sets = plan.image_sets,
        .given = cameras.given,
        .known = cameras.pose_refinement,
        .known_pairs = pairs_of(earlier),
        .threads = estimate.in_flight,
        .progress = until_stopped(
            run.stop, "stopped: all photos are done and kept; run the same command again to continue",
            progress)};
    result.agreement = std::make_shared<const Agreement>(finish_package(finish, plan.photos));
    return result;
}

}  // namespace vantage
