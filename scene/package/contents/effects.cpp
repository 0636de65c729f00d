#include "scene/package/contents/effects.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/text/error.h"

namespace vantage {
namespace {

/// Packages store `name`, `measures` and `unit`, so changing one of these changes every package.
constexpr std::array table{
    EffectRow{Effect::undistortion, "undistortion", "undistortion",
              "largest displacement by the lens in any photo", "px", 0.05, Basis::scene, "blend",
              "PHOTO_LENS"},
    EffectRow{Effect::per_fragment, "per-fragment", "per-fragment",
              "triangle size in the photos, 95th percentile by area", "px", 2.0, Basis::scene, "blend",
              "PER_FRAGMENT"},
    EffectRow{Effect::fov_normalization, "fov-normalization", "fov-normalization",
              "spread of the photos' focal lengths, max/min - 1", "", 0.05, Basis::scene, "", ""},
    EffectRow{Effect::vertex_colors, "vertex-colors", "vertex-colors",
              "share of colored vertices that no photo sees", "", 0.001, Basis::scene, "surface",
              "VERTEX_COLORS"},
    EffectRow{Effect::exposure, "exposure", "exposure",
              "color difference between photos of the same surface, median |ln ratio|", "", 0.02,
              Basis::colors, "blend", "PHOTO_GAIN"},
    EffectRow{Effect::vignetting, "vignetting", "vignetting",
              "largest share of light lost in a lens's corners", "", 0.05, Basis::colors, "blend",
              "PHOTO_VIGNETTING"},
    EffectRow{Effect::pose_refinement, "pose-refinement", "pose-refinement",
              "displacement between photos on the model, relative to its limit (1 px; 1.5 px per pair)", "",
              1, Basis::pixels, "", ""},
    EffectRow{Effect::transients, "transients", "transients",
              "largest share of a photo that others contradict", "", 0.005, Basis::pixels, "blend",
              "PHOTO_TRANSIENTS"},
    EffectRow{Effect::background, "background", "background",
              "share of the photos that the mesh does not cover", "", 0.005, Basis::background, "", ""},
    EffectRow{Effect::scalar_fields, "scalar-fields", "scalar-fields",
              "fields of the mesh with more than one value", "", 0, Basis::scene, "", ""},
    EffectRow{Effect::points, "points", "points", "points of the clouds", "", 0, Basis::scene, "resolve",
              "POINTS"},
    EffectRow{Effect::image_sets, "image-sets", "image-sets", "photo sets that are shown one at a time", "",
              1, Basis::scene, "show", "IMAGE_SETS"},
    EffectRow{Effect::transparency, "transparency", "transparency",
              "share of the triangles that are not opaque", "", 0, Basis::scene, "resolve", "TRANSPARENCY"},
    EffectRow{Effect::compact, "compact", "compact",
              "raw tiles, weight maps and depth, relative to the photos' files", "", 1, Basis::scene, "", ""},
};
static_assert(table.size() == std::size_t(Effect::count));
static_assert(std::ranges::is_sorted(table, {}, &EffectRow::effect), "rows are in the order of Effect");

}  // namespace

std::span<const EffectRow> effect_table() { return table; }

EffectChoice choice_of(const std::map<Effect, EffectChoice>& choices, Effect effect) {
    const auto it = choices.find(effect);
    return it == choices.end() ? EffectChoice::automatic : it->second;
}

EffectDecision decide(Effect effect, EffectChoice choice, double measured, std::string evidence) {
    EffectDecision d{effect, false, choice != EffectChoice::automatic, measured, std::move(evidence)};
    d.on = d.forced ? choice == EffectChoice::on
                    : std::isfinite(measured) && measured > effect_row(effect).threshold;
    return d;
}

const EffectRow& effect_row(Effect effect) { return table[std::size_t(effect)]; }

const EffectRow& effect_row(std::string_view name) {
    std::string known;
    for (const EffectRow& row : table) {
        if (name == row.name || name == row.option) return row;
        known += (known.empty() ? "" : ", ") + std::string(row.option);
    }
    throw Error(Exit::usage, "unknown effect '" + std::string(name) + "', expected one of " + known);
}

EffectSet effects_from(Basis basis) {
    EffectSet set = 0;
    for (const EffectRow& row : table)
        if (row.basis == basis) set |= effect_bit(row.effect);
    return set;
}

std::vector<std::string> shader_defines(std::string_view program, EffectSet on) {
    std::vector<std::string> defines;
    for (const EffectRow& row : table)
        if (program == row.program && on & effect_bit(row.effect)) defines.emplace_back(row.define);
    return defines;
}

}  // namespace vantage
