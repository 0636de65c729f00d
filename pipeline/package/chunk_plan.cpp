#include "pipeline/package/chunk_plan.h"

#include <algorithm>

#include "pipeline/stages/surface_samples.h"
#include "scene/package_reader.h"
#include "scene/tiling.h"

namespace vantage {

using package::Type;

namespace {

/// Levels of the tile pyramid. Photos that were left out keep theirs: they may become readable.
int planned_levels(const package::PhotoRecord& p) {
    return p.flags & package::photo_held_out ? 0 : level_count(int(p.width), int(p.height));
}

/// A share has no results that depend on all photos: neither REGI nor PAIR.
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
    if (sizes.bands) plan.push_back(whole(Type::bands, sizes.bands * sizeof(package::BandRecord)));
    if (sizes.point_nodes)
        plan.push_back(whole(Type::point_nodes, sizes.point_nodes * sizeof(package::PointNode)));
    return plan;
}

/// Not what is small, nor what is written record by record, nor points.
bool can_be_compact(const ChunkPlan& chunk) {
    switch (chunk.type) {
        case Type::positions:
        case Type::normals:
        case Type::indices:
        case Type::clusters:
        case Type::colors:
        case Type::scalars:
        case Type::thumbnail:
        case Type::coverage:
        case Type::visible:
        case Type::samples:
        case Type::coordinates:
        case Type::tiles:
        case Type::masks:
        case Type::depth:
            return true;
        default:
            return false;
    }
}

}  // namespace

bool stores_coordinates(const package::SceneRecord& scene, bool asked) {
    return asked || !effect_on(scene, Effect::compact) || !effect_on(scene, Effect::per_fragment);
}

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
        plan.push_back({Type::samples, i, 0, package::surface_discs * sizeof(package::SampleRecord)});
    });
    if (sizes.coordinates)
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
    if (sizes.point_blocks)
        plan.push_back({Type::points, package::scene_wide, 0, 0, sizes.point_blocks,
                        package::point_block * sizeof(package::PackedPoint)});
    for (ChunkPlan& chunk : plan) chunk.compact = effect_on(scene, Effect::compact) && can_be_compact(chunk);
    return plan;
}

}  // namespace vantage
