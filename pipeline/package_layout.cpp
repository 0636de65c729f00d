#include "pipeline/package_layout.h"

#include <algorithm>
#include <cstring>
#include <set>

#include "pipeline/stages/clusters.h"
#include "pipeline/stages/pyramid.h"
#include "pipeline/stages/surface_samples.h"
#include "scene/checksum.h"
#include "scene/error.h"

namespace vantage {

using package::Type;

namespace {

/// The place of each vertex in the order of first use.
std::vector<std::uint32_t> order_of_use(const std::vector<std::uint32_t>& indices, std::size_t vertices) {
    constexpr std::uint32_t unused = ~0u;
    std::vector<std::uint32_t> place(vertices, unused);
    std::uint32_t next = 0;
    for (const std::uint32_t v : indices)
        if (place[v] == unused) place[v] = next++;
    for (std::uint32_t& p : place)
        if (p == unused) p = next++;
    return place;
}

template <class T>
void move_to(std::vector<T>& values, const std::vector<std::uint32_t>& place) {
    if (values.empty()) return;
    std::vector<T> moved(values.size());
    for (std::size_t v = 0; v < values.size(); ++v) moved[place[v]] = values[v];
    values = std::move(moved);
}

void order_vertices(PackedModel& m, Mesh& mesh) {
    const std::vector<std::uint32_t> place = order_of_use(m.indices, m.positions.size());
    move_to(m.positions, place);
    move_to(mesh.positions, place);
    move_to(mesh.normals, place);
    move_to(mesh.colors, place);
    for (ScalarLayer& layer : mesh.scalars) move_to(layer.values, place);
    for (std::uint32_t& v : m.indices) v = place[v];
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        std::copy_n(m.indices.begin() + std::ptrdiff_t(3 * t), 3, mesh.triangles[t].begin());
}

}  // namespace

PackedModel pack_model(Mesh& mesh, unsigned cluster_triangles) {
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
    order_vertices(m, mesh);
    Eigen::Map<Eigen::Vector3d>(m.record.origin) = m.origin;
    Eigen::Map<Eigen::Vector3d>(m.record.bounds_min) = low;
    Eigen::Map<Eigen::Vector3d>(m.record.bounds_max) = high;
    m.record.vertices = m.positions.size();
    m.record.triangles = m.indices.size() / 3;
    m.record.clusters = m.clusters.size();
    return m;
}

namespace {

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
    set_pose(photo.camera.cam_from_world.relative_to(origin), r);
    for (double& g : r.gain) g = 1;
    return r;
}

}  // namespace

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

namespace {

/// Of the tile pyramid, also where the photo was left out: it may be readable one day.
int planned_levels(const package::PhotoRecord& p) {
    return p.flags & package::photo_held_out ? 0 : level_count(int(p.width), int(p.height));
}

/// A share knows nothing of photos together.
std::vector<ChunkPlan> plan_scene(const package::SceneRecord& s, const LayoutSizes& sizes, bool share) {
    const auto whole = [](Type type, std::uint64_t bytes) {
        return ChunkPlan{type, package::scene_wide, 0, bytes};
    };
    std::vector<ChunkPlan> plan{whole(Type::meta, sizes.meta_bytes),
                                whole(Type::scene, sizeof(package::SceneRecord)),
                                whole(Type::photos, s.photos * sizeof(package::PhotoRecord)),
                                whole(Type::states, s.photos * sizeof(package::PhotoState)),
                                whole(Type::positions, s.vertices * 12),
                                whole(Type::normals, s.vertices * 12),
                                whole(Type::indices, s.triangles * 12),
                                whole(Type::clusters, s.clusters * sizeof(package::ClusterRecord))};
    if (!share) {
        plan.push_back(whole(Type::registration, s.photos * sizeof(package::RegistrationRecord)));
        plan.push_back(
            whole(Type::pairs, s.photos * package::stored_pairs_per_photo * sizeof(package::PairRecord)));
    }
    if (sizes.colors) plan.push_back(whole(Type::colors, s.vertices * 4));
    if (s.scalar_layers) plan.push_back(whole(Type::scalars, s.vertices * 4 * s.scalar_layers));
    return plan;
}

}  // namespace

std::vector<ChunkPlan> plan_chunks(const package::SceneRecord& scene, const LayoutSizes& sizes,
                                   std::span<const package::PhotoRecord> photos, Share share) {
    std::vector<ChunkPlan> plan = plan_scene(scene, sizes, share.shares > 0);
    int top = 0;
    const auto each = [&](const auto& add) {
        for (std::uint32_t i = 0; i < photos.size(); ++i)
            if (const int levels = planned_levels(photos[i]); levels > 0 && share.holds(i))
                add(i, photos[i], levels);
    };
    each([&](std::uint32_t i, const package::PhotoRecord& p, int levels) {
        plan.push_back({Type::thumbnail, i, 0, std::uint64_t(p.thumbnail_width) * p.thumbnail_height * 4});
        top = std::max(top, levels);
    });
    each([&](std::uint32_t i, const auto&, int) {
        plan.push_back({Type::coverage, i, 0, scene.clusters * sizeof(package::CoverageRecord)});
    });
    each([&](std::uint32_t i, const auto&, int) {
        plan.push_back({Type::visible, i, 0, 16 * package::visible_words(scene.triangles)});
    });
    each([&](std::uint32_t i, const auto&, int) {
        plan.push_back({Type::samples, i, 0, surface_discs * sizeof(package::SampleRecord)});
    });
    each([&](std::uint32_t i, const auto&, int) {
        plan.push_back({Type::coordinates, i, 0, scene.vertices * 8});
    });
    for (int level = mask_levels_end(top); level-- > 0;) {
        for (const Type type : {Type::tiles, Type::masks, Type::depth})
            each([&](std::uint32_t i, const package::PhotoRecord& p, int levels) {
                const bool has = type == Type::tiles ? level < levels
                                                     : level >= mask_level && level < mask_levels_end(levels);
                const auto n = std::uint64_t(level_size(int(p.width), int(p.height), level).tiles());
                if (has) plan.push_back({type, i, std::uint32_t(level), 0, n, tile_bytes});
            });
    }
    return plan;
}

std::uint64_t names_checksum(std::span<const package::PhotoRecord> photos) {
    std::string names;
    for (const package::PhotoRecord& p : photos) names += std::string(p.name) + '\n';
    return checksum(std::as_bytes(std::span(names)));
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

}  // namespace vantage
