#include "scene/package/chunk_table.h"

#include <algorithm>
#include <array>

#include "base/values/tiling.h"
#include "scene/package/package_format.h"

namespace vantage {
std::span<const ChunkRow> chunk_table() {
    using package::PhotoRecord, package::SceneRecord, package::Stage, package::Type;
    using enum ChunkLevels;
    using enum ChunkWrite;
    using Count = std::uint64_t;
    constexpr auto one = [](const SceneRecord&, const PhotoRecord&) { return Count(1); };
    constexpr auto per_photo = [](const SceneRecord& s, const PhotoRecord&) { return s.photos; };
    constexpr auto per_vertex = [](const SceneRecord& s, const PhotoRecord&) { return s.vertices; };
    constexpr auto per_triangle = [](const SceneRecord& s, const PhotoRecord&) { return s.triangles; };
    constexpr auto per_cluster = [](const SceneRecord& s, const PhotoRecord&) { return s.clusters; };
    constexpr auto field_values = [](const SceneRecord& s, const PhotoRecord&) {
        return s.vertices * s.scalar_fields;
    };
    constexpr auto pairs = [](const SceneRecord& s, const PhotoRecord&) {
        return s.photos * package::stored_pairs_per_photo;
    };
    constexpr auto pixels = [](const SceneRecord&, const PhotoRecord& p) {
        return Count(p.thumbnail_width) * p.thumbnail_height;
    };
    constexpr auto words = [](const SceneRecord& s, const PhotoRecord&) {
        return package::visible_words(s.triangles);
    };
    constexpr auto discs = [](const SceneRecord&, const PhotoRecord&) {
        return Count(package::surface_discs);
    };
    constexpr Stage none = Stage::count;
    static constexpr std::array table{
        ChunkRow{Type::meta},
        ChunkRow{Type::scene, nullptr, none, single, false, sizeof(SceneRecord), one, "one record"},
        ChunkRow{Type::photos, nullptr, none, single, false, sizeof(PhotoRecord), per_photo,
                 "one record per photo", last},
        ChunkRow{Type::states, nullptr, none, single, false, sizeof(package::PhotoState), per_photo,
                 "one entry per photo", last},
        ChunkRow{Type::positions, "positions", none, single, true, 12, per_vertex, "one entry per vertex"},
        ChunkRow{Type::normals, "normals", none, single, true, 12, per_vertex, "one entry per vertex"},
        ChunkRow{Type::indices, "triangles", none, single, true, 12, per_triangle,
                 "three indices per triangle"},
        ChunkRow{Type::clusters, "clusters", none, single, true, sizeof(package::ClusterRecord), per_cluster,
                 "one record per cluster"},
        ChunkRow{Type::pose_refinement, nullptr, none, single, false, sizeof(package::PoseRefinementRecord),
                 per_photo, "one record per photo", last},
        ChunkRow{Type::pairs, nullptr, none, single, false, sizeof(package::PairRecord), pairs,
                 "two records per photo", last},
        ChunkRow{Type::colors, "colors", none, single, true, 4, per_vertex, "one color per vertex"},
        ChunkRow{Type::scalars, "scalars", none, single, true, 4, field_values,
                 "one value per vertex and field"},
        ChunkRow{Type::image_sets, "image_sets", none, single, false, sizeof(package::ImageSetRecord)},
        ChunkRow{Type::lenses, "lenses", none, single, false, sizeof(package::LensRecord), per_photo,
                 "one record per photo"},
        ChunkRow{Type::point_nodes, "octree of points", none, single, false, sizeof(package::PointNode)},
        ChunkRow{Type::thumbnail, "thumbnail", Stage::thumbnail, single, true, 4, pixels,
                 "the size stated in the photo's record"},
        ChunkRow{Type::coverage, "coverage", Stage::coverage, single, true, sizeof(package::CoverageRecord),
                 per_cluster, "one entry per cluster"},
        ChunkRow{Type::visible, "visible triangles", Stage::coverage, single, true, 16, words,
                 "two bits per triangle"},
        ChunkRow{Type::samples, "samples", Stage::samples, single, true, sizeof(package::SampleRecord), discs,
                 "one entry per disc"},
        ChunkRow{Type::coordinates, "coordinates", Stage::coordinates, single, true, 8, per_vertex,
                 "one entry per vertex"},
        ChunkRow{Type::tiles, "tiles", Stage::tiles, tiles, true},
        ChunkRow{Type::weight_maps, "weight maps", Stage::weight_maps, weight_maps, true},
        ChunkRow{Type::depth, "depth", Stage::weight_maps, weight_maps, true},
        ChunkRow{Type::points, "points", none, single, false, sizeof(package::PackedPoint)},
        ChunkRow{Type::background, "background", none, single, false, 0, nullptr, "", appended},
        ChunkRow{Type::pose_refinement_without, nullptr, none, single, false, 0, nullptr, "", appended},
    };
    return table;
}

std::uint64_t ChunkRow::length(const package::SceneRecord& scene) const {
    return length(scene, package::PhotoRecord{});
}

std::uint64_t ChunkRow::length(const package::SceneRecord& scene, const package::PhotoRecord& photo) const {
    return count(scene, photo) * record;
}

const ChunkRow& chunk_row(package::Type type) {
    return *std::ranges::find(chunk_table(), type, &ChunkRow::type);
}

bool has_chunk(const ChunkRow& row, int level, int levels) {
    if (row.levels == ChunkLevels::single) return level == 0;
    return row.levels == ChunkLevels::tiles
               ? level < levels
               : level >= weight_map_level && level < weight_map_levels_end(levels);
}

std::vector<LeveledChunk> chunks_of_photo(int levels) {
    std::vector<LeveledChunk> out;
    for (int level = 0; level < weight_map_levels_end(levels); ++level)
        for (const ChunkRow& row : chunk_table())
            if (row.per_photo() && has_chunk(row, level, levels)) out.push_back({&row, std::uint32_t(level)});
    return out;
}

}  // namespace vantage
