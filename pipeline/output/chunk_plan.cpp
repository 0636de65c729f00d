#include "pipeline/output/chunk_plan.h"

#include <algorithm>
#include <optional>

#include "base/values/tiling.h"
#include "scene/package/chunk_table.h"
#include "scene/package/package_reader.h"

namespace vantage {

using package::Type;

namespace {

/// Levels of the tile pyramid. Photos that were skipped keep theirs: they may become readable.
int planned_levels(const package::PhotoRecord& p) {
    return p.flags & package::photo_held_out ? 0 : level_count(int(p.width), int(p.height));
}

/// The bytes of a chunk of the scene; nothing if it has none that is planned.
std::optional<std::uint64_t> scene_bytes(const ChunkRow& row, const package::SceneRecord& scene,
                                         const LayoutSizes& sizes, bool share) {
    const auto of_records = [&](std::uint64_t count) {
        return count ? std::optional(count * row.record) : std::nullopt;
    };
    switch (row.type) {
        case Type::meta:
            return sizes.meta_bytes;
        case Type::image_sets:
            return of_records(sizes.image_sets);
        case Type::lenses:
            if (!effect_on(scene, Effect::undistortion)) return {};
            break;
        case Type::point_nodes:
            return of_records(sizes.point_nodes);
        case Type::pose_refinement:  // a share has no results that depend on all photos
        case Type::pairs:
            if (share) return {};
            break;
        case Type::colors:
            if (!sizes.colors) return {};
            break;
        case Type::scalars:
            if (!scene.scalar_fields) return {};
            break;
        default:
            break;
    }
    return row.count ? std::optional(row.length(scene)) : std::nullopt;
}

}  // namespace

bool stores_coordinates(const package::SceneRecord& scene, bool asked) {
    return asked || !effect_on(scene, Effect::compact) || !effect_on(scene, Effect::per_fragment);
}

std::vector<ChunkPlan> plan_chunks(const package::SceneRecord& scene, const LayoutSizes& sizes,
                                   std::span<const package::PhotoRecord> photos, Share share) {
    std::vector<ChunkPlan> plan;
    int top = 0;
    const auto each = [&](const auto& add) {
        for (std::uint32_t i = 0; i < photos.size(); ++i)
            if (const int levels = planned_levels(photos[i]); levels > 0 && share.holds(i))
                add(i, photos[i], levels);
    };
    for (const ChunkRow& row : chunk_table()) {
        if (row.levels != ChunkLevels::single || (row.type == Type::coordinates && !sizes.coordinates))
            continue;
        if (row.per_photo())
            each([&](std::uint32_t i, const package::PhotoRecord& p, int levels) {
                plan.push_back({row.type, i, 0, row.length(scene, p)});
                top = std::max(top, levels);
            });
        else if (const auto bytes = scene_bytes(row, scene, sizes, share.shares > 0))
            plan.push_back({row.type, package::scene_wide, 0, *bytes});
    }
    for (int level = weight_map_levels_end(top); level-- > 0;)
        for (const ChunkRow& row : chunk_table()) {
            if (row.levels == ChunkLevels::single) continue;
            each([&](std::uint32_t i, const package::PhotoRecord& p, int levels) {
                const auto n = std::uint64_t(level_size(int(p.width), int(p.height), level).tiles());
                if (has_chunk(row, level, levels))
                    plan.push_back({row.type, i, std::uint32_t(level), 0, n, tile_bytes});
            });
        }
    if (sizes.point_blocks)
        plan.push_back({Type::points, package::scene_wide, 0, 0, sizes.point_blocks,
                        package::point_block * sizeof(package::PackedPoint)});
    for (ChunkPlan& chunk : plan)
        chunk.compact = effect_on(scene, Effect::compact) && chunk_row(chunk.type).compact;
    return plan;
}

}  // namespace vantage
