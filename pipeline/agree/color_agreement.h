#pragma once
#include <map>
#include <span>
#include <string>
#include <vector>

#include "pipeline/agree/color_fit.h"
#include "scene/effects.h"
#include "scene/package_format.h"

namespace vantage {

/// How far the photos' colours disagree, what makes them agree, and whether the scene calls for it.
struct ColorRefinement {
    ColorFit fit;
    std::vector<std::uint32_t> lens;  ///< a photo
    EffectDecision exposure, falloff;
};

/// `samples`: a photo's discs, or none. Gains and falloff count only where photos disagree (by the effects'
/// thresholds) and a tenth of it goes away, or where they are forced.
ColorRefinement refine_colors(std::span<const package::PhotoRecord> photos, Samples samples,
                              const std::map<Effect, EffectChoice>& choices);

/// Into the records of the photos that are shown: gain and falloff, as far as their effects are on.
void apply_colors(const ColorRefinement& refinement, std::span<package::PhotoRecord> photos);

}  // namespace vantage
