#pragma once
#include <map>
#include <span>
#include <string>
#include <vector>

#include "colors/color_fit.h"
#include "scene/effects.h"
#include "scene/package_format.h"

namespace vantage {

/// How much the photos' colors disagree, the gains and falloff that reduce it, and whether the scene needs
/// them.
struct ColorRefinement {
    ColorFit fit;
    std::vector<std::uint32_t> lens;  ///< per photo, see lenses_of
    EffectDecision exposure, falloff;
};

/// Exposure gains are on if photos disagree by more than the effect's threshold and gains remove at least a
/// tenth of that; falloff is on above its own threshold, but not without gains. `choices` overrides both.
ColorRefinement refine_colors(std::span<const package::PhotoRecord> photos, Samples samples,
                              const std::map<Effect, EffectChoice>& choices);

/// Writes gains and falloff into the photos' records; identity for effects that are off.
void apply_colors(const ColorRefinement& refinement, std::span<package::PhotoRecord> photos);

}  // namespace vantage
