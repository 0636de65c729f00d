#include "pipeline/prepare.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <exception>
#include <future>
#include <limits>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "pipeline/file_identity.h"
#include "pipeline/gl_thread.h"
#include "pipeline/import/photos.h"
#include "pipeline/stages/clusters.h"
#include "pipeline/stages/inspect.h"
#include "pipeline/stages/masks.h"
#include "pipeline/stages/photo_geometry.h"
#include "pipeline/stages/pyramid.h"
#include "pipeline/stages/undistort.h"
#include "pipeline/stages/visibility.h"
#include "scene/checksum.h"
#include "scene/error.h"
#include "scene/package_writer.h"

namespace vantage {
namespace {

using package::Type;

/// The scene as the package holds it: centred, single precision, ordered by cluster.
struct PackedModel {
    package::SceneRecord record{};
    Eigen::Vector3d origin;
    std::vector<Eigen::Vector3f> positions;
    std::vector<std::uint32_t> indices;
    std::vector<package::ClusterRecord> clusters;
};

PackedModel pack_model(const Mesh& mesh, unsigned cluster_triangles) {
    PackedModel m;
    Eigen::Vector3d low = mesh.positions.front(), high = low;
    for (const Eigen::Vector3d& p : mesh.positions) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    m.origin = low + (high - low) / 2;
    m.positions.reserve(mesh.positions.size());
    for (const Eigen::Vector3d& p : mesh.positions) m.positions.push_back((p - m.origin).cast<float>());
    for (const auto& t : mesh.triangles) m.indices.insert(m.indices.end(), t.begin(), t.end());
    m.clusters = make_clusters(m.positions, m.indices, cluster_triangles);
    Eigen::Map<Eigen::Vector3d>(m.record.origin) = m.origin;
    Eigen::Map<Eigen::Vector3d>(m.record.bounds_min) = low;
    Eigen::Map<Eigen::Vector3d>(m.record.bounds_max) = high;
    m.record.vertices = m.positions.size();
    m.record.triangles = m.indices.size() / 3;
    m.record.clusters = m.clusters.size();
    return m;
}

package::PhotoRecord photo_record(const PhotoInput& photo, const Eigen::Vector3d& origin, int thumbnail,
                                  bool held_out) {
    package::PhotoRecord r{};
    if (photo.name.size() >= sizeof r.name)
        throw Error(Exit::input,
                    photo.name + ": name is longer than " + std::to_string(sizeof r.name - 1) + " bytes");
    std::memcpy(r.name, photo.name.data(), photo.name.size());
    const Intrinsics& k = photo.camera.intrinsics;
    r.width = std::uint32_t(k.width);
    r.height = std::uint32_t(k.height);
    r.flags = held_out ? std::uint32_t(package::photo_held_out) : 0;
    r.levels = held_out ? 0 : std::uint32_t(level_count(k.width, k.height));
    const Level small = thumbnail_size(k.width, k.height, thumbnail),
                half = level_size(k.width, k.height, mask_level);
    r.thumbnail_width = std::uint32_t(small.width);
    r.thumbnail_height = std::uint32_t(small.height);
    r.mask_width = std::uint32_t(half.width);
    r.mask_height = std::uint32_t(half.height);
    r.fx = k.fx, r.fy = k.fy, r.cx = k.cx, r.cy = k.cy;
    const Pose pose = photo.camera.cam_from_world.relative_to(origin);
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> R(r.R);
    R = pose.R;
    Eigen::Map<Eigen::Vector3d> t(r.t);
    t = pose.t;
    for (double& g : r.gain) g = 1;
    return r;
}

nlohmann::json provenance(const SceneInput& scene, const PrepareSettings& s,
                          const std::vector<EffectDecision>& effects) {
    nlohmann::json meta;
    meta["tool"] = "vantage " VANTAGE_VERSION;
    meta["config"] = {{"distance", name(s.distance)},
                      {"border_width", s.border_width},
                      {"border_threshold", s.border_threshold},
                      {"thumbnail", s.thumbnail},
                      {"cluster_triangles", s.cluster_triangles},
                      {"photo_size", s.photo_size},
                      {"hold_out", s.hold_out}};
    const auto input = [](const std::filesystem::path& file) {
        const FileIdentity id = identify(file);
        return nlohmann::json{{"name", file.filename().string()}, {"bytes", id.bytes}, {"xxh3", id.checksum}};
    };
    meta["inputs"]["mesh"] = input(scene.files.mesh);
    meta["inputs"]["camera_format"] = scene.camera_format;
    for (const auto& file : camera_files(scene.files.cameras))
        meta["inputs"]["cameras"].push_back(input(file));
    for (const EffectDecision& d : effects) {
        const EffectRow& row = effect_row(d.effect);
        meta["effects"].push_back({{"name", row.name},
                                   {"on", d.on},
                                   {"forced", d.forced},
                                   {"measures", row.measures},
                                   {"measured", d.measured},
                                   {"threshold", row.threshold},
                                   {"unit", row.unit},
                                   {"evidence", d.evidence}});
    }
    meta["scalars"] = nlohmann::json::array();
    for (const ScalarLayer& layer : scene.mesh.scalars) meta["scalars"].push_back(layer.name);
    meta["warnings"] = scene.warnings;
    return meta;
}

/// Every chunk in file order: coarse before fine.
std::vector<ChunkPlan> plan_chunks(const PackedModel& m, const Mesh& mesh, std::size_t meta_bytes,
                                   const std::vector<package::PhotoRecord>& photos) {
    const std::uint64_t v = m.record.vertices;
    const auto whole = [](Type type, std::uint64_t bytes) {
        return ChunkPlan{type, package::scene_wide, 0, bytes};
    };
    std::vector<ChunkPlan> plan{whole(Type::meta, meta_bytes),
                                whole(Type::scene, sizeof(package::SceneRecord)),
                                whole(Type::photos, photos.size() * sizeof(package::PhotoRecord)),
                                whole(Type::positions, v * 12),
                                whole(Type::normals, v * 12),
                                whole(Type::indices, m.record.triangles * 12),
                                whole(Type::clusters, m.clusters.size() * sizeof(package::ClusterRecord))};
    if (!mesh.colors.empty()) plan.push_back(whole(Type::colors, v * 4));
    if (!mesh.scalars.empty()) plan.push_back(whole(Type::scalars, v * 4 * mesh.scalars.size()));
    std::uint32_t top = 0;
    const auto each = [&](const auto& add) {
        for (std::uint32_t i = 0; i < photos.size(); ++i)
            if (photos[i].levels) add(i, photos[i]);
    };
    each([&](std::uint32_t i, const package::PhotoRecord& p) {
        plan.push_back({Type::thumbnail, i, 0, std::uint64_t(p.thumbnail_width) * p.thumbnail_height * 4});
        top = std::max(top, p.levels);
    });
    each([&](std::uint32_t i, const auto&) {
        plan.push_back({Type::coverage, i, 0, m.clusters.size() * sizeof(package::CoverageRecord)});
    });
    each([&](std::uint32_t i, const auto&) { plan.push_back({Type::coordinates, i, 0, v * 8}); });
    const auto tiles = [&](Type type, std::uint32_t i, const package::PhotoRecord& p, std::uint32_t level) {
        const auto n = std::uint64_t(level_size(int(p.width), int(p.height), int(level)).tiles());
        plan.push_back({type, i, level, 0, n, tile_bytes});
    };
    for (std::uint32_t level = top; level-- > 0;) {
        each([&](std::uint32_t i, const auto& p) {
            if (level < p.levels) tiles(Type::tiles, i, p, level);
        });
        if (level == std::uint32_t(mask_level) || (level == 0 && top <= std::uint32_t(mask_level))) {
            each([&](std::uint32_t i, const auto& p) { tiles(Type::masks, i, p, mask_level); });
            each([&](std::uint32_t i, const auto& p) { tiles(Type::depth, i, p, mask_level); });
        }
    }
    return plan;
}

void write_model(PackageWriter& writer, const PackedModel& m, const Mesh& mesh) {
    const auto put = [&](Type type, std::span<const std::byte> bytes) {
        writer.write(type, package::scene_wide, bytes);
    };
    put(Type::scene, std::as_bytes(std::span(&m.record, 1)));
    put(Type::positions, bytes_of(m.positions));
    put(Type::normals, bytes_of(mesh.normals));
    put(Type::indices, bytes_of(m.indices));
    put(Type::clusters, bytes_of(m.clusters));
    if (!mesh.colors.empty()) put(Type::colors, bytes_of(mesh.colors));
    if (mesh.scalars.empty()) return;
    std::vector<float> all;
    for (const ScalarLayer& layer : mesh.scalars)
        all.insert(all.end(), layer.values.begin(), layer.values.end());
    put(Type::scalars, bytes_of(all));
}

/// What every photo's stages read.
struct Stages {
    const SceneInput& scene;
    const PrepareSettings& settings;
    const PackedModel& model;
    const ModelBuffers& buffers;
    GlThread& gl;
    PackageWriter& writer;
    std::shared_future<RayScene> rays;
};

RgbaImage read_pixels(const Stages& s, const PhotoInput& photo, package::PhotoRecord& r) {
    const std::vector<std::byte> bytes = read_file(photo.file);
    const FileIdentity id = identify(bytes);
    r.source_bytes = id.bytes;
    r.source_checksum = id.checksum;
    RgbaPhoto read = decode_photo(photo.file, bytes, photo.decoded);
    RgbaImage image{read.width, read.height, std::move(read.rgba)};
    const int longest = int(std::max(r.width, r.height));
    if (std::max(image.width, image.height) > longest) image = thumbnail(image, longest);
    if (!(s.model.record.effects >> int(Effect::undistortion) & 1) || !photo.camera.lens.distorts())
        return image;
    r.flags |= package::photo_undistorted;
    return undistort(image, photo.camera);
}

/// Validity of a level's texels, 0 or 1; empty where the photo is opaque.
std::vector<std::uint8_t> validity(const RgbaImage& level) {
    std::vector<std::uint8_t> valid(level.rgba.size() / 4);
    for (std::size_t p = 0; p < valid.size(); ++p) valid[p] = level.rgba[4 * p + 3] == 255;
    return valid;
}

void write_tiles(PackageWriter& writer, Type type, std::uint32_t photo, std::uint32_t level,
                 std::span<const std::byte> texels, const Level& size) {
    writer.write_blocks(type, photo, level, [&](std::size_t number, std::span<std::byte> tile) {
        cut_tile(texels, size, number, tile);
    });
}

/// Thumbnail and tile pyramid. Returns the photo's validity at `mask_level`, empty where it is opaque.
std::vector<std::uint8_t> write_pixels(const Stages& s, std::uint32_t i, RgbaImage level,
                                       package::PhotoRecord& r) {
    std::uint8_t all_alpha = 255;
    for (std::size_t p = 3; p < level.rgba.size(); p += 4) all_alpha &= level.rgba[p];
    const bool opaque = all_alpha == 255;
    if (!opaque) r.flags |= package::photo_has_alpha;
    std::vector<std::uint8_t> valid;
    bool thumbnail_due = true;
    const std::uint32_t last = std::max(r.levels, std::uint32_t(mask_level) + 1);
    for (std::uint32_t l = 0; l < last; ++l) {
        if (l == std::uint32_t(mask_level) && !opaque) valid = validity(level);
        if (l < r.levels)
            write_tiles(s.writer, Type::tiles, i, l, bytes_of(level.rgba), {level.width, level.height});
        RgbaImage next = halve(level);
        // The coarsest level that still has the thumbnail's detail is the cheapest to reduce.
        const int wanted = int(std::max(r.thumbnail_width, r.thumbnail_height));
        if (thumbnail_due && (std::max(next.width, next.height) < wanted || l + 1 == last)) {
            RgbaImage small = thumbnail(level, wanted);
            s.writer.write(Type::thumbnail, i, std::as_bytes(std::span(small.rgba)));
            thumbnail_due = false;
        }
        level = std::move(next);
    }
    return valid;
}

std::vector<float> distances(const Stages& s, std::vector<std::uint8_t> borders, const PhotoGeometry& g) {
    DistanceMethod method = s.settings.distance;
    if (method == DistanceMethod::automatic)
        method = s.gl.device().software ? DistanceMethod::exact : DistanceMethod::jfa_squared;
    if (method == DistanceMethod::exact) return exact_distance(borders, g.width, g.height);
    return s.gl.submit([&] { return flood_distance(borders, g.width, g.height, method); }).get();
}

void write_masks(const Stages& s, std::uint32_t i, const PhotoGeometry& g, std::vector<std::uint8_t> valid,
                 const Intrinsics& k) {
    const Level level{g.width, g.height};
    const DepthMap depth{g.width, g.height, g.z, std::move(valid)};
    const double scale = 1.0 / (1 << mask_level);
    const double full = s.settings.border_width * k.width / 3072 * scale;
    const auto border = border_mask(distances(s, find_borders(depth, float(s.settings.border_threshold)), g),
                                    g.width, g.height, float(full));
    const auto masks = combine_masks(g, border, std::sqrt(k.fx * k.fy), s.model.record.reference_density);
    write_tiles(s.writer, Type::masks, i, mask_level, bytes_of(masks), level);
    write_tiles(s.writer, Type::depth, i, mask_level, bytes_of(g.z), level);
}

void write_coverage(const Stages& s, std::uint32_t i, const PhotoGeometry& g, const Intrinsics& k,
                    const Pose& pose) {
    s.writer.write(Type::coordinates, i, bytes_of(g.coordinates));
    s.writer.write(Type::coverage, i,
                   bytes_of(measure_coverage(s.model.clusters, s.model.indices, g.coordinates, k, pose)));
}

void record_findings(const PhotoGeometry& g, const Intrinsics& k, const Pose& pose, package::PhotoRecord& r) {
    const SeenHull hull = seen_hull(g.coordinates, k, pose);
    Eigen::Map<Eigen::Vector3d>(r.corrected_direction) = hull.direction;
    r.hull_area = hull.area;
    const auto seen =
        std::count_if(g.coordinates.begin(), g.coordinates.end(), [](const auto& uv) { return uv.x() >= 0; });
    r.visible_vertices = g.coordinates.empty() ? 0 : double(seen) / double(g.coordinates.size());
    float nearest = std::numeric_limits<float>::infinity(), farthest = 0;
    for (const float z : g.z) {
        nearest = std::min(nearest, z);
        farthest = std::isinf(z) ? farthest : std::max(farthest, z);
    }
    if (std::isinf(nearest)) return;
    r.z_min = double(nearest);
    r.z_max = double(farthest);
    std::vector<float> some;  // a median needs no more
    for (std::size_t i = 0; i < g.z.size(); i += g.z.size() < 65536 ? 1 : 7)
        if (std::isfinite(g.z[i])) some.push_back(g.z[i]);
    if (some.empty()) some.push_back(nearest);
    const auto middle = some.begin() + std::ptrdiff_t(some.size() / 2);
    std::nth_element(some.begin(), middle, some.end());
    r.seen_distance = double(*middle);
}

/// One photo through all stages. The OpenGL work runs while the photo is decoded and cut.
void run_photo(const Stages& s, std::uint32_t i, package::PhotoRecord& r) {
    const PhotoInput& photo = s.scene.photos[i];
    const Intrinsics k = photo.camera.intrinsics;
    const Pose pose = photo.camera.cam_from_world.relative_to(s.model.origin);
    const Eigen::Vector2d range = depth_range(s.model.positions, pose);
    const std::vector<std::uint32_t> triangles =
        triangles_in_frame(s.model.clusters, s.model.indices, k, pose);
    auto pending = s.gl.submit([&] { return render_geometry(s.buffers, triangles, k, pose, range); });
    std::vector<std::uint8_t> valid;
    try {
        if (r.levels) valid = write_pixels(s, i, read_pixels(s, photo, r), r);
    } catch (...) {
        pending.wait();  // it refers to this frame
        throw;
    }
    PhotoGeometry geometry = pending.get();
    settle_visibility(s.rays.get(), s.model.positions, k, pose, geometry.coordinates);
    record_findings(geometry, k, pose, r);
    if (!r.levels) return;
    write_masks(s, i, geometry, std::move(valid), k);
    write_coverage(s, i, geometry, k, pose);
}

/// Runs the photos on `threads` threads; the first exception ends the rest and is thrown here.
void run_photos(const Stages& s, std::vector<package::PhotoRecord>& records, unsigned threads,
                const std::function<void(const Progress&)>& progress) {
    std::atomic<std::uint32_t> next{0};
    std::mutex mutex;
    std::exception_ptr failure;
    std::size_t done = 0;
    {
        std::vector<std::jthread> pool;
        for (unsigned t = 0; t < threads; ++t)
            pool.emplace_back([&] {
                for (std::uint32_t i; (i = next++) < records.size();) try {
                        run_photo(s, i, records[i]);
                        const std::scoped_lock lock(mutex);
                        progress({"photos", records[i].name, ++done, records.size()});
                    } catch (...) {
                        const std::scoped_lock lock(mutex);
                        if (!failure) failure = std::current_exception();
                        next = std::uint32_t(records.size());
                    }
            });
    }
    if (failure) std::rethrow_exception(failure);
}

std::vector<package::PhotoRecord> photo_records(const SceneInput& scene, const PrepareSettings& settings,
                                                const Eigen::Vector3d& origin) {
    std::set<std::string> held(settings.hold_out.begin(), settings.hold_out.end());
    std::vector<package::PhotoRecord> records;
    for (const PhotoInput& photo : scene.photos) {
        const std::string stem = photo.name.substr(0, photo.name.rfind('.'));
        const bool out = held.erase(photo.name) + held.erase(stem) > 0;
        records.push_back(photo_record(photo, origin, settings.thumbnail, out));
    }
    if (!held.empty())
        throw Error(Exit::usage, "--hold-out " + *held.begin() + ": the scene has no such photo");
    return records;
}

/// Cameras for photos of at most `longest` pixels on the long side.
void reduce_photos(SceneInput& scene, int longest) {
    for (PhotoInput& photo : scene.photos) {
        Intrinsics& k = photo.camera.intrinsics;
        const Level size = thumbnail_size(k.width, k.height, longest);
        k = k.scaled(size.width, size.height);
    }
}

}  // namespace

void prepare(SceneInput scene, const PrepareSettings& settings, const std::filesystem::path& out,
             const std::function<void(const Progress&)>& progress) {
    if (settings.photo_size > 0) reduce_photos(scene, settings.photo_size);
    if (scene.mesh.points_only())
        throw Error(Exit::input,
                    scene.files.mesh.string() + ": has points only, expected a mesh with triangles");
    GlThread gl;
    progress({"inspect", "", 0, scene.photos.size()});
    const std::vector<EffectDecision> effects = inspect(scene, settings.effects);
    PackedModel model = pack_model(scene.mesh, settings.cluster_triangles);
    std::vector<package::PhotoRecord> records = photo_records(scene, settings, model.origin);
    model.record.photos = records.size();
    model.record.reference_density = finest_density(scene);
    model.record.border_width = settings.border_width;
    model.record.scalar_layers = scene.mesh.scalars.size();
    for (const EffectDecision& d : effects) model.record.effects |= std::uint64_t(d.on) << int(d.effect);
    const std::string meta = provenance(scene, settings, effects).dump(1);
    PackageWriter writer(out, plan_chunks(model, scene.mesh, meta.size(), records));
    writer.write(Type::meta, package::scene_wide, std::as_bytes(std::span(meta)));
    write_model(writer, model, scene.mesh);

    gl.device();
    ModelBuffers buffers;
    auto uploaded = gl.submit([&] { buffers = upload_model(model.positions, scene.mesh.normals); });
    auto rays = std::async(std::launch::async, [&] { return RayScene(model.positions, model.indices); });
    const Stages stages{scene, settings, model, buffers, gl, writer, rays.share()};
    const unsigned threads =
        settings.threads ? settings.threads : std::max(1u, std::thread::hardware_concurrency());
    std::exception_ptr failure;
    try {
        run_photos(stages, records, threads, progress);
        uploaded.get();
    } catch (...) {
        failure = std::current_exception();
    }
    gl.submit([&] { buffers = {}; }).get();  // released on the thread that made them
    if (failure) std::rethrow_exception(failure);
    writer.write(Type::photos, package::scene_wide, bytes_of(records));
    progress({"pack", "", records.size(), records.size()});
    writer.finish();
}

}  // namespace vantage
