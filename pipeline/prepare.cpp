#include "pipeline/prepare.h"

#include <mutex>

#include "pipeline/for_each_photo.h"
#include "pipeline/photo_stages.h"
#include "pipeline/stages/inspect.h"
#include "pipeline/stages/pyramid.h"
#include "pipeline/stages/subdivide.h"
#include "scene/checksum.h"
#include "scene/error.h"

namespace vantage {
namespace {

using package::Type;

void run_photos(const PhotoStages& s, std::vector<package::PhotoRecord>& records, unsigned threads,
                const std::function<void(const Progress&)>& progress) {
    std::mutex mutex;
    std::size_t done = 0;
    for_each_photo(records.size(), threads, [&](std::size_t i) {
        run_photo(s, std::uint32_t(i), records[i]);
        const std::scoped_lock lock(mutex);
        progress({"photos", records[i].name, ++done, records.size()});
    });
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

}  // namespace

void prepare(SceneInput scene, const PrepareSettings& settings, const std::filesystem::path& out,
             const std::function<void(const Progress&)>& progress) {
    if (settings.photo_size > 0) reduce_photos(scene, settings.photo_size);
    if (scene.mesh.points_only())
        throw Error(Exit::input,
                    scene.files.mesh.string() + ": has points only, expected a mesh with triangles");
    GlThread gl;
    progress({"inspect", "", 0, scene.photos.size()});
    subdivide_large_triangles(scene.mesh);
    PackedModel model = pack_model(scene.mesh, settings.cluster_triangles);
    const DistanceMethod distance = settled(settings.distance, gl.device());
    UploadedModel uploaded(gl, model, scene.mesh.normals, distance);
    auto rays = std::async(std::launch::async, [&] { return RayScene(model.positions, model.indices); });
    const std::vector<EffectDecision> effects = inspect(scene, settings.effects);
    std::vector<package::PhotoRecord> records = photo_records(scene, settings, model.origin);
    model.record.photos = records.size();
    model.record.reference_density = finest_density(scene);
    model.record.border_width = settings.border_width;
    model.record.scalar_layers = scene.mesh.scalars.size();
    for (const EffectDecision& d : effects) model.record.effects |= std::uint64_t(d.on) << int(d.effect);
    const std::string meta = provenance(scene, settings, effects);
    PackageWriter writer(out, plan_chunks(model, scene.mesh, meta.size(), records));
    writer.write(Type::meta, package::scene_wide, std::as_bytes(std::span(meta)));
    write_model(writer, model, scene.mesh);

    run_photos({scene, settings, model, uploaded.get(), gl, writer, distance, rays.share()}, records,
               settings.threads, progress);
    writer.write(Type::photos, package::scene_wide, bytes_of(records));
    progress({"pack", "", records.size(), records.size()});
    writer.finish();
}

}  // namespace vantage
