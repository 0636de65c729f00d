#pragma once
#include <map>
#include <span>
#include <string>
#include <vector>

#include "pipeline/refine/folds.h"
#include "pipeline/refine/prediction.h"
#include "scene/agreement/color_fit.h"
#include "scene/package/contents/effects.h"
#include "scene/package/package_format.h"

namespace vantage {

/// The disagreement of the photos' colors, the gains and vignetting that reduce it, and the decisions on
/// them.
struct ColorRefinement {
    ColorFit fit;
    std::vector<std::uint32_t> lens;  ///< per photo, see lenses_of
    EffectDecision exposure, vignetting;
    std::vector<PhotoColors> without{};  ///< per fold: fitted without its photo; empty if not validated
};

/// Gains are needed if photos disagree by more than the effect's threshold and gains remove at least a tenth
/// of that; vignetting must be corrected above its own threshold, but not without gains. A correction that is
/// needed is then tested on held-out photos (see is_called_for), unless `folds` is null or a choice forces
/// it. `fit`: the fit to these samples and lenses, with vignetting unless it is turned off.
ColorRefinement refine_colors(ColorFit fit, std::vector<std::uint32_t> lens, Samples samples,
                              const std::map<Effect, EffectChoice>& choices, const Folds* folds = nullptr);

/// Per fold, the colors of all other photos, fitted without the fold's photo: with gains alone, and with
/// vignetting as well (empty if not wanted).
struct FoldColors {
    std::vector<PhotoColors> gains, both;
};
FoldColors colors_without(const Folds& folds, std::span<const std::uint32_t> lens, bool vignetting);

/// The colors in the form in which predict() applies them; they must outlive the result.
Alternative alternative(const PhotoColors& colors, bool gains_on, bool vignetting_on, std::uint32_t photo);

/// Writes gains and vignetting into the photos' records; identity for effects that are off.
void apply_colors(const ColorRefinement& refinement, std::span<package::PhotoRecord> photos);

}  // namespace vantage
