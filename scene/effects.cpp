#include "scene/effects.h"

#include <array>
#include <cmath>

#include "scene/error.h"

namespace vantage {
namespace {

constexpr std::array table{
    EffectRow{Effect::undistortion, "undistortion", "largest displacement by the lens in any photo", "px",
              0.05, "", "resample photos to a pinhole camera"},
    EffectRow{Effect::per_fragment, "per-fragment", "triangle size in the photos, 95th percentile by area",
              "px", 2.0, "PER_FRAGMENT", "project and depth-test every fragment instead of every vertex"},
    EffectRow{Effect::fov_normalisation, "fov-normalisation",
              "spread of the photos' focal lengths, max/min - 1", "", 0.05, "FOV_NORMALISATION",
              "compare distances as if all photos had one field of view"},
    EffectRow{Effect::vertex_colors, "vertex-colors", "share of vertices with a colour that no photo sees",
              "", 0.001, "VERTEX_COLORS", "show the mesh's own colours where no photo sees"},
    EffectRow{Effect::exposure, "exposure", "how far photos of one surface differ, median |ln ratio|", "",
              0.02, "PHOTO_GAIN", "give all photos one exposure and white balance"},
    EffectRow{Effect::falloff, "falloff", "light that a lens loses in the corner", "", 0.05, "PHOTO_FALLOFF",
              "take the lens's falloff out"},
    EffectRow{Effect::registration, "registration",
              "how far photos lie from each other on the model, over what is usual (1 px, 1.5 px a pair)", "",
              1, "", "move cameras so that photos of one surface fit"},
    EffectRow{Effect::consensus, "consensus", "largest share of a photo that others contradict", "", 0.005,
              "PHOTO_CONSENSUS", "leave out what single photos show and others agree is not there"},
};
static_assert(table.size() == std::size_t(Effect::count));

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

const EffectRow& effect_row(const std::string& name) {
    std::string known;
    for (const EffectRow& row : table) {
        if (name == row.name) return row;
        known += (known.empty() ? "" : ", ") + std::string(row.name);
    }
    throw Error(Exit::usage, "unknown effect '" + name + "', expected one of " + known);
}

}  // namespace vantage
