#include "pipeline/output/stage_table.h"

#include <algorithm>

#include "pipeline/stages/coordinates/coordinates.h"
#include "pipeline/stages/coverage.h"
#include "pipeline/stages/surface_samples.h"
#include "pipeline/stages/tile_levels.h"
#include "pipeline/stages/weight_maps.h"

namespace vantage {
namespace {

using package::PhotoRecord;
using package::Stage;

void key_thumbnail(Fingerprint& f, const SceneKey& scene) { f.add(scene.settings.thumbnail); }

/// The numbers of the distance methods in the keys of weight maps.
constexpr int exact_distances = 1, flooded_distances = 5;

void key_weight_maps(Fingerprint& f, const SceneKey& scene) {
    f.add(scene.distance == DistanceMethod::exact ? exact_distances : flooded_distances)
        .add(scene.reference_density);
}

void key_samples(Fingerprint& f, const SceneKey& scene) { f.add(scene.reference_density); }

void adopt_tiles(const PhotoRecord& from, PhotoRecord& to) {
    to.flags |= from.flags & package::photo_has_alpha;
}

void adopt_coordinates(const PhotoRecord& from, PhotoRecord& to) {
    std::copy_n(from.corrected_direction, 3, to.corrected_direction);
    to.hull_area = from.hull_area;
    to.seen_distance = from.seen_distance;
    to.z_min = from.z_min;
    to.z_max = from.z_max;
    to.visible_vertices = from.visible_vertices;
}

}  // namespace

std::span<const StageRow> stage_table() {
    static_assert(stage_count <= package::max_stages);
    static const std::array<StageRow, stage_count> table{{
        {.stage = Stage::thumbnail,
         .name = "thumbnail",
         .version = 2,
         .pixels = PixelInput::all,
         .model = false,
         .held_out = false,
         .settings = {"photo_size", "thumbnail"},
         .key = key_thumbnail,
         .adopt = nullptr,
         .make = nullptr,
         .make_level = make_thumbnail},
        {.stage = Stage::tiles,
         .name = "tiles",
         .version = 4,
         .pixels = PixelInput::all,
         .model = false,
         .held_out = false,
         .settings = {"photo_size"},
         .key = nullptr,
         .adopt = adopt_tiles,
         .make = nullptr,
         .make_level = make_tiles},
        {.stage = Stage::weight_maps,
         .name = "weight maps",
         .version = 5,
         .pixels = PixelInput::alpha,
         .model = true,
         .held_out = false,
         .settings = {"photo_size", "distance", "render_by"},
         .key = key_weight_maps,
         .adopt = nullptr,
         .make = make_weight_maps,
         .make_level = nullptr},
        {.stage = Stage::coordinates,
         .name = "coordinates",
         .version = 4,
         .pixels = PixelInput::none,
         .model = true,
         .held_out = true,
         .settings = {"photo_size", "render_by"},
         .key = nullptr,
         .adopt = adopt_coordinates,
         .make = make_coordinates,
         .make_level = nullptr},
        {.stage = Stage::coverage,
         .name = "coverage",
         .version = 4,
         .pixels = PixelInput::none,
         .model = true,
         .held_out = false,
         .settings = {"photo_size", "render_by"},
         .key = nullptr,
         .adopt = nullptr,
         .make = make_coverage,
         .make_level = nullptr},
        {.stage = Stage::samples,
         .name = "samples",
         .version = 4,
         .pixels = PixelInput::all,
         .model = true,
         .held_out = false,
         .settings = {"photo_size", "render_by"},
         .key = key_samples,
         .adopt = nullptr,
         .make = make_samples,
         .make_level = nullptr},
    }};
    return table;
}

const StageRow& stage_row(Stage stage) { return stage_table()[std::size_t(stage)]; }

std::vector<LeveledChunk> chunks_of(Stage stage, int levels) {
    std::vector<LeveledChunk> chunks = chunks_of_photo(levels);
    std::erase_if(chunks, [&](const LeveledChunk& c) { return c.row->stage != stage; });
    return chunks;
}

std::vector<Stage> stages_of(const PhotoRecord& record) {
    const bool held_out = record.flags & package::photo_held_out;
    std::vector<Stage> stages;
    for (const StageRow& row : stage_table())
        if (!held_out || row.held_out) stages.push_back(row.stage);
    return stages;
}

bool StageSet::needs_model() const {
    return std::ranges::any_of(stage_table(),
                               [&](const StageRow& row) { return (*this)[row.stage] && row.model; });
}

bool StageSet::needs_pixels(bool has_alpha) const {
    return std::ranges::any_of(stage_table(), [&](const StageRow& row) {
        return (*this)[row.stage] &&
               (row.pixels == PixelInput::all || (row.pixels == PixelInput::alpha && has_alpha));
    });
}

void make_on_model(StageInput& in, const StageSet& missing) {
    for (const bool reads_pixels : {false, true})
        for (const StageRow& row : stage_table())
            if (row.make && missing[row.stage] && (row.pixels != PixelInput::none) == reads_pixels)
                row.make(in);
}

void make_on_level(LevelInput& in, const StageSet& missing) {
    for (const StageRow& row : stage_table())
        if (row.make_level && missing[row.stage]) row.make_level(in);
}

StageSet stages_on_model() {
    StageSet set;
    for (const StageRow& row : stage_table())
        if (row.model) set.add(row.stage);
    return set;
}

}  // namespace vantage
