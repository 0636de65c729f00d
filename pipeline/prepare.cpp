#include "pipeline/prepare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <nlohmann/json.hpp>

#include "pipeline/for_each_photo.h"
#include "pipeline/photo_stages.h"
#include "pipeline/provenance.h"
#include "pipeline/stages/inspect.h"
#include "pipeline/stages/pyramid.h"
#include "pipeline/stages/subdivide.h"
#include "pipeline/trace.h"
#include "scene/error.h"

namespace vantage {
namespace {

using package::Type;

/// What is known of the photos while they are prepared, each by its own thread.
struct Photos {
    std::vector<package::PhotoRecord> records;
    std::vector<package::PhotoState> states;
};

/// Counts stages, and why those that were made had to be.
class Tally {
  public:
    Tally(const SceneInput& scene, nlohmann::json settings,
          const std::vector<std::unique_ptr<Former>>& formers)
        : scene_(scene), settings_(std::move(settings)), formers_(formers) {}

    void add(std::size_t i, const Photos& photos, const std::vector<package::Stage>& made) {
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

void run_photos(const PhotoStages& s, Photos& photos, const PrepareRun& run, Tally& tally,
                const std::function<void(const Progress&)>& progress) {
    std::mutex mutex;
    std::size_t done = 0, total = 0;
    for (std::size_t i = 0; i < photos.records.size(); ++i) total += run.share.holds(i);
    for_each_photo(photos.records.size(), s.key.settings.threads, [&](std::size_t i) {
        if (!run.share.holds(i) || (run.stop && *run.stop)) return;
        const auto made = run_photo(s, std::uint32_t(i), photos.records[i], photos.states[i]);
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
void note_left_out(const SceneInput& scene, const Photos& photos, PrepareResult& result) {
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

/// Cameras for photos of at most `longest` pixels on the long side.
void reduce_photos(SceneInput& scene, int longest) {
    for (PhotoInput& photo : scene.photos) {
        Intrinsics& k = photo.camera.intrinsics;
        const Level size = thumbnail_size(k.width, k.height, longest);
        k = k.scaled(size.width, size.height);
    }
}

DistanceMethod settled(DistanceMethod method, const gl::Device& device) {
    if (method != DistanceMethod::automatic) return method;
    return device.software ? DistanceMethod::exact : DistanceMethod::jfa_squared;
}

/// The model's buffers, made on the OpenGL thread while others work, and released there.
class UploadedModel {
  public:
    UploadedModel(GlThread& gl, const PackedModel& model, const std::vector<Eigen::Vector3f>& normals,
                  DistanceMethod distance)
        : gl_(gl), done_(gl.submit([&, distance] {
              buffers_ = upload_model(model.positions, normals);
              if (distance != DistanceMethod::exact) buffers_.jump_flood = jump_flood_program();
          })) {}
    ~UploadedModel() {
        gl_.submit([this] { buffers_ = {}; }).wait();
    }
    UploadedModel(const UploadedModel&) = delete;
    UploadedModel& operator=(const UploadedModel&) = delete;

    const ModelBuffers& get() {
        done_.get();
        return buffers_;
    }

  private:
    GlThread& gl_;
    ModelBuffers buffers_;
    std::future<void> done_;
};

/// An octave of the depth mask is twelve of its steps: rounded up to the next, the reference does not move
/// with every photo that comes or goes, and all masks with it.
double reference_density(const SceneInput& scene) {
    return std::exp2(std::ceil(std::log2(finest_density(scene))));
}

void complete_record(package::SceneRecord& record, const SceneInput& scene, const PrepareSettings& settings,
                     const std::vector<EffectDecision>& effects) {
    record.photos = scene.photos.size();
    record.reference_density = reference_density(scene);
    record.border_width = settings.border_width;
    record.scalar_layers = scene.mesh.scalars.size();
    for (const EffectDecision& d : effects) record.effects |= std::uint64_t(d.on) << int(d.effect);
}

}  // namespace

PrepareResult prepare(SceneInput scene, const PrepareSettings& settings, const std::filesystem::path& out,
                 const std::function<void(const Progress&)>& progress, const PrepareRun& run) {
    if (settings.photo_size > 0) reduce_photos(scene, settings.photo_size);
    if (scene.mesh.points_only())
        throw Error(Exit::input,
                    scene.files.mesh.string() + ": has points only, expected a mesh with triangles");
    if (run.strict && !scene.left_out.empty())
        throw Error(Exit::input, scene.left_out.front().photo + ": " + scene.left_out.front().why);
    GlThread gl;
    IdentityCache identities(usual_identity_cache(), run.rehash);
    progress({"inspect", "", 0, scene.photos.size()});
    PackedModel model = [&] {
        const Traced traced(run.trace, "model");
        subdivide_large_triangles(scene.mesh);
        return pack_model(scene.mesh, settings.cluster_triangles);
    }();
    const DistanceMethod distance = settled(settings.distance, gl.device());
    UploadedModel uploaded(gl, model, scene.mesh.normals, distance);
    auto rays = std::async(std::launch::async, [&] {
        const Traced traced(run.trace, "rays");
        return RayScene(model.positions, model.indices);
    });
    const std::vector<EffectDecision> effects = [&] {
        const Traced traced(run.trace, "inspect");
        return inspect(scene, settings.effects);
    }();
    complete_record(model.record, scene, settings, effects);
    Photos photos{photo_records(scene, settings, model.origin), {}};
    photos.states.resize(photos.records.size());
    const std::string meta = provenance(scene, settings, effects, identities);
    PackageWriter writer(
        out, plan_chunks(model.record, {meta.size(), !scene.mesh.colors.empty()}, photos.records, run.share),
        names_checksum(photos.records), run.share);
    const auto formers = formers_of(out, writer.resumed());
    {
        const Traced traced(run.trace, "write model");
        writer.write(Type::meta, package::scene_wide, std::as_bytes(std::span(meta)));
        write_model(writer, model, scene.mesh);
    }
    const SceneKey key{settings, distance, bool(model.record.effects >> int(Effect::undistortion) & 1),
                       model_checksum(model, scene.mesh.normals), model.record.reference_density};
    Tally tally(scene, nlohmann::json::parse(meta)["config"], formers);
    run_photos({scene, key, model, uploaded.get(), gl, writer, identities, formers, rays.share(), run.strict,
                run.trace},
               photos, run, tally, progress);
    note_left_out(scene, photos, tally.result);
    writer.write(Type::photos, package::scene_wide, bytes_of(photos.records));
    writer.write(Type::states, package::scene_wide, bytes_of(photos.states));
    progress({"pack", "", photos.records.size(), photos.records.size()});
    const Traced traced(run.trace, "flush");
    writer.finish();
    return tally.result;
}

}  // namespace vantage
