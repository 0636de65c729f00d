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

/// The gains and vignetting that make the photos' colors agree better, the disagreement with and without
/// them, and the decisions on whether to apply them.
struct ColorRefinement {
    ColorFit fit;
    std::vector<std::uint32_t> lens;  ///< per photo, see lenses_of
    EffectDecision exposure, vignetting;
    std::vector<PhotoColors> without{};  ///< per fold, fitted without its photo; empty if not validated
};

/// Gains are needed if photos disagree by more than the effect's threshold and gains remove at least a tenth
/// of the disagreement. Vignetting must be corrected if it exceeds its own threshold, but only together with
/// gains. A correction that is needed is then tested on held-out photos (see is_called_for), unless `folds`
/// is null or a choice forces the correction. `fit`: the fit to these samples and lenses, including
/// vignetting unless it is turned off.
ColorRefinement refine_colors(ColorFit fit, std::vector<std::uint32_t> lens, Samples samples,
                              const std::map<Effect, EffectChoice>& choices, const Folds* folds = nullptr);

/// For each fold, the colors of all other photos, fitted without the fold's photo: with gains alone, and with
/// both gains and vignetting (empty if `vignetting` is false).
struct FoldColors {
    std::vector<PhotoColors> gains, both;
};
FoldColors colors_without(const Folds& folds, std::span<const std::uint32_t> lens, bool vignetting);

/// Converts the colors to the form in which predict() applies them. `colors` must outlive the result.
Alternative alternative(const PhotoColors& colors, bool gains_on, bool vignetting_on, std::uint32_t photo);

/// Writes gains and vignetting to the photos' records. For an effect that is off, it writes neutral values.
void apply_colors(const ColorRefinement& refinement, std::span<package::PhotoRecord> photos);

}  // namespace vantage
