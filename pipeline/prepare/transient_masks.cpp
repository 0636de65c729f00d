#include "pipeline/prepare/transient_masks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/files/checksum.h"
#include "base/text/error.h"
#include "base/values/bytes_of.h"
#include "base/values/tiling.h"
#include "pipeline/output/earlier_package.h"
#include "pipeline/refine/transient.h"
#include "pipeline/refine/verdict.h"
#include "pipeline/run/for_each_photo.h"
#include "pipeline/stages/tile_levels.h"
#include "scene/agreement/transient_weights.h"

namespace vantage {
namespace {

using package::PhotoRecord;
using package::Type;

/// Writes the weight maps' fourth channel at all levels: 255 if `map` is null, and never 0 where the photo
/// sees the model.
void write_weights(const PackageReader& part, PackageWriter& writer, std::uint32_t photo,
                   const PhotoRecord& r, const TransientMap* map) {
    for (int l = weight_map_level; l < weight_map_levels_end(int(r.levels)); ++l) {
        const Level size = level_size(int(r.width), int(r.height), l);
        std::vector<std::byte> weight_maps = read_level(part, r, photo, Type::weight_maps, l);
        set_weights(map, size, {weight_maps.data(), 4 * size.width, size.height}, 0, 0);
        write_tiles(writer, Type::weight_maps, photo, std::uint32_t(l), {weight_maps, size});
    }
}

/// The checksum of the map; 0 if no part of the photo is contradicted.
std::uint64_t key_of(const TransientMap& map) {
    if (std::ranges::all_of(map.weight, [](std::uint8_t w) { return w == 255; })) return 0;
    return checksum(bytes_of(map.weight));
}

void update_weight_maps(const FinishInput& in, const PackageReader& part, std::uint32_t i,
                        const TransientMap& map, const PhotoRecord& r, package::PhotoState& state) {
    const std::uint64_t key = key_of(map);
    if (r.levels == 0 || state.transients == key) return;
    const Traced traced(in.geometry.trace, "transient masks", r.name);
    PackageWriter& writer = in.geometry.writer;
    write_weights(part, writer, i, r, key ? &map : nullptr);
    state.transients = key;
    state.stages[std::size_t(package::Stage::weight_maps)].content =
        content_of(package::Stage::weight_maps, i, int(r.levels), writer);
    seal(state, r);
    writer.note(Type::states, i, bytes_of_one(state));
}

EffectDecision decide_transients(std::span<const PhotoRecord> photos, const std::vector<TransientMap>& maps,
                                 EffectChoice choice) {
    const auto worst = std::ranges::max_element(maps, {}, &TransientMap::disagreeing);
    if (worst == maps.end() || std::ranges::all_of(maps, [](const auto& m) { return m.weight.empty(); }))
        return decide(Effect::transients, choice, 0,
                      "no photo sees a part of the surface that two others see");
    return decide(Effect::transients, choice, worst->disagreeing,
                  fmt::format("other photos contradict {:.2f} % of the surface in {}, the most of any photo",
                              100 * worst->disagreeing, photos[std::size_t(worst - maps.begin())].name));
}

/// Validates the effect with held-out photos. Colors are fitted without the held-out photo, even if no color
/// effect is on.
void confirm(const FinishInput& in, const Folds& folds, const TransientViews& views,
             const TransientPartners& partners, const ColorRefinement& colors, EffectDecision& decision) {
    const Traced traced(in.geometry.trace, "judge transient masking");
    const auto fits =
        colors.without.empty() ? colors_without(folds, colors.lens, false).gains : colors.without;
    const Judgment validated =
        validate_transients(folds, views, partners, fits, colors.exposure.on, colors.vignetting.on);
    confirm(decision, validated);
}

/// Views at the resolution of the weight maps, which is twice the resolution of the evidence.
TransientViews finer_views(const PackageReader& part, std::span<const PhotoRecord> photos) {
    return {cached_views, [&part, photos](std::uint32_t i) {
                TransientView view = read_transient_view(part, photos[i], i, transient_level(photos[i]));
                part.forget_all();
                return view;
            }};
}

/// Sets the decision and the evidence per photo in `out`. Returns the maps to apply, which are empty if the
/// effect is off.
std::vector<TransientMap> decide_weights(const FinishInput& in, const PackageReader& part, const Folds& folds,
                                         const ColorRefinement& colors, std::span<const PhotoRecord> photos,
                                         TransientMasks& out) {
    const TransientPartners partners(folds.shared());
    const PhotoColors all = colors_of(colors.fit, colors.lens);
    const TransientViews views(cached_views,
                               [&](std::uint32_t i) { return transient_view(*folds.photo(i)); });
    const std::vector<TransientMap> evidence = transient_maps(views, all, partners, in.threads);
    out.decision = decide_transients(photos, evidence, choice_of(in.choices, Effect::transients));
    for (std::size_t i = 0; i < photos.size(); ++i) out.disagreeing[i] = evidence[i].disagreeing;
    if (out.decision.on && in.validate) confirm(in, folds, views, partners, colors, out.decision);
    if (!out.decision.on) return std::vector<TransientMap>(photos.size());
    return transient_maps(finer_views(part, photos), all, partners, in.threads);
}

}  // namespace

TransientMasks find_transients(const FinishInput& in, const PackageReader& part, const Folds& folds,
                               const ColorRefinement& colors, PhotoTables& photos) {
    const Traced traced(in.geometry.trace, "transients");
    const std::size_t n = photos.records.size();
    TransientMasks out;
    out.disagreeing.resize(n);
    std::vector<TransientMap> maps(n);
    if (choice_of(in.choices, Effect::transients) == EffectChoice::off)
        out.decision = decide(Effect::transients, EffectChoice::off, 0, "not measured");
    else
        maps = decide_weights(in, part, folds, colors, photos.records, out);
    for_each_photo(n, in.threads, [&](std::size_t i) {
        update_weight_maps(in, part, std::uint32_t(i), maps[i], photos.records[i], photos.states[i]);
    });
    return out;
}

}  // namespace vantage
