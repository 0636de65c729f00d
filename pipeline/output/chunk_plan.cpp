#include "pipeline/output/chunk_plan.h"

#include <algorithm>
#include <optional>

#include "base/values/tiling.h"
#include "scene/package/chunk_table.h"

namespace vantage {

using package::Type;

namespace {

/// The number of levels of the tile pyramid. Skipped photos keep their levels, because they may become
/// readable.
int planned_levels(const package::PhotoRecord& p) {
    return p.flags & package::photo_held_out ? 0 : level_count(int(p.width), int(p.height));
}

/// The bytes of a scene chunk; empty if none is planned.
std::optional<std::uint64_t> scene_bytes(const ChunkRow& row, const package::SceneRecord& scene,
                                         const LayoutSizes& sizes, bool share) {
    if (const auto known = sizes.bytes.find(row.type); known != sizes.bytes.end())
        return known->second ? std::optional(known->second) : std::nullopt;
    switch (row.type) {
        case Type::lenses:
            if (!effect_on(scene, Effect::undistortion)) return {};
            break;
        case Type::pose_refinement:  // a shard has no results that depend on all photos
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

LayoutSizes layout_sizes(const PackageReader& package, std::uint64_t meta_bytes, bool coordinates) {
    const package::DirectoryEntry* points = package.find(Type::points);
    LayoutSizes out{.bytes = {},
                    .colors = package.find(Type::colors) != nullptr,
                    .point_blocks = points ? package.blocks(*points) : 0,
                    .coordinates = coordinates};
    for (const ChunkRow& row : chunk_table())
        if (!row.per_photo() && !row.count && row.type != Type::points && row.write == ChunkWrite::planned)
            out.bytes[row.type] = package.content_length(package.find(row.type));
    out.bytes[Type::meta] = meta_bytes;
    return out;
}

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
