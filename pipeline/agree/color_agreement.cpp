#include "pipeline/agree/color_agreement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vantage {
namespace {

constexpr double min_improvement = 0.1;  ///< share of the disagreement that gains must remove

EffectDecision decide_exposure(const ColorFit& fit, EffectChoice wanted) {
    if (!fit.shares_surface())
        return decide(Effect::exposure, wanted, 0, "no two photos share enough surface");
    const bool helps = fit.after <= (1 - min_improvement) * fit.before;
    return decide(
        Effect::exposure, wanted, helps ? fit.before : 0,
        fmt::format("the photos' colors of the same surface differ by {:.1f} % (median), with gains "
                    "by {:.1f} %",
                    percent(fit.before), percent(fit.after)));
}

/// The share of the light that is lost in the corner.
double corner_loss(const Falloff& f) { return -std::expm1(-log_falloff(f, 1)); }

EffectDecision decide_falloff(const ColorFit& fit, EffectChoice wanted) {
    double largest = 0;
    for (const Falloff& f : fit.falloff) largest = std::max(largest, corner_loss(f));
    return decide(Effect::falloff, wanted, largest,
                  largest > 0
                      ? fmt::format("lenses lose up to {:.0f} % of the light in the corners", 100 * largest)
                      : "no lens falloff was found");
}

}  // namespace

ColorRefinement refine_colors(std::span<const package::PhotoRecord> photos, Samples samples,
                              const std::map<Effect, EffectChoice>& choices) {
    const std::vector<std::uint32_t> lens = lenses_of(photos);
    const EffectChoice falloff = choice_of(choices, Effect::falloff),
                       exposure = choice_of(choices, Effect::exposure);
    ColorRefinement out{fit_colors(samples, lens, falloff != EffectChoice::off), lens, {}, {}};
    out.exposure = decide_exposure(out.fit, exposure);
    out.falloff = decide_falloff(out.fit, falloff);
    // Unless forced, falloff is corrected only together with exposure.
    if (!out.exposure.on && falloff == EffectChoice::automatic) out.falloff.on = false;
    return out;
}

void apply_colors(const ColorRefinement& r, std::span<package::PhotoRecord> photos) {
    for (std::size_t i = 0; i < photos.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c)
            photos[i].gain[c] = r.exposure.on ? std::exp(r.fit.ln_gain[i][c]) : 1;
        for (std::size_t t = 0; t < 3; ++t)
            photos[i].falloff[t] = r.falloff.on ? float(r.fit.falloff[r.lens[i]][t]) : 0;
    }
}

}  // namespace vantage
