#include "pipeline/refine/color_agreement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <future>

#include "pipeline/refine/prediction.h"
#include "pipeline/refine/verdict.h"
#include "pipeline/run/for_each_photo.h"

namespace vantage {
namespace {

constexpr double min_improvement = 0.1;  ///< fraction of the disagreement that gains must remove

EffectDecision decide_exposure(const ColorFit& fit, EffectChoice wanted) {
    if (!fit.shares_surface())
        return decide(Effect::exposure, wanted, 0, "no two photos see enough of the same surface");
    const bool helps = fit.after <= (1 - min_improvement) * fit.before;
    return decide(Effect::exposure, wanted, helps ? fit.before : 0,
                  fmt::format("colors of the same surface differ between photos by {:.1f} % (median), or by "
                              "{:.1f} % after gains",
                              percent(fit.before), percent(fit.after)));
}

/// The fraction of the light that is lost in the corner of a photo.
double corner_loss(const Vignetting& f) { return -std::expm1(-log_vignetting(f, 1)); }

EffectDecision decide_vignetting(const ColorFit& fit, EffectChoice wanted) {
    double largest = 0;
    for (const Vignetting& f : fit.vignetting) largest = std::max(largest, corner_loss(f));
    return decide(Effect::vignetting, wanted, largest,
                  largest > 0
                      ? fmt::format("lenses lose up to {:.0f} % of the light in the corners", 100 * largest)
                      : "no lens vignetting was found");
}

/// The validation of gains, and of the additional benefit of correcting vignetting. `both`: the colors with
/// vignetting, empty if there is no vignetting.
struct ColorJudgments {
    Judgment exposure, vignetting;
};
ColorJudgments validate_colors(const Folds& folds, std::span<const PhotoColors> gains,
                               std::span<const PhotoColors> both) {
    std::vector<ValidatedPhoto> with_gain(folds.all().size()), with_vignetting(folds.all().size());
    folds.each([&](const Folds::View& v) {
        const auto kept = v.sightings();
        const Sightings& seen = *kept;
        const std::size_t f = v.index;
        std::vector<Prediction> predictions{
            predict(v.target, seen, {}),
            predict(v.target, seen, alternative(gains[f], true, false, v.fold.photo))};
        if (!both.empty())
            predictions.push_back(predict(v.target, seen, alternative(both[f], true, true, v.fold.photo)));
        const std::vector<ValidationScore> scores = score(own_color(v.target), predictions);
        const std::string name = folds.input().photos[v.fold.photo].name;
        with_gain[f] = {name, scores[0], scores[1]};
        with_vignetting[f] = {name, scores[1], scores.back()};
    });
    return {summarize(with_gain), summarize(with_vignetting)};
}

}  // namespace

Alternative alternative(const PhotoColors& colors, bool gains_on, bool vignetting_on, std::uint32_t photo) {
    Alternative a;
    if (gains_on) a.ln_gain = colors.ln_gain;
    if (vignetting_on) a.vignetting = colors.vignetting, a.view_vignetting = colors.vignetting[photo];
    return a;
}

FoldColors colors_without(const Folds& folds, std::span<const std::uint32_t> lens, bool vignetting) {
    const PhotoSamples some = samples_to_fit(folds.input().samples);
    const std::size_t n = folds.all().size();
    FoldColors out{std::vector<PhotoColors>(n), std::vector<PhotoColors>(vignetting ? n : 0)};
    for_each_photo(n, folds.input().threads, [&](std::size_t f) {
        const std::uint32_t photo = folds.all()[f].photo;
        if (vignetting) {
            FitsWithout fits = fits_without(some.spans(), lens, photo);
            out.gains[f] = std::move(fits.gains);
            out.both[f] = std::move(fits.both);
        } else {
            out.gains[f] = fit_without(some.spans(), lens, photo, false);
        }
    });
    return out;
}

ColorRefinement refine_colors(ColorFit fit, std::vector<std::uint32_t> lens, Samples samples,
                              const std::map<Effect, EffectChoice>& choices, const Folds* folds) {
    const EffectChoice vignetting = choice_of(choices, Effect::vignetting),
                       exposure = choice_of(choices, Effect::exposure);
    // The photos are read one at a time, which takes less memory than if each thread read its own.
    std::future<void> reading;
    if (folds && exposure != EffectChoice::off)
        reading = std::async(std::launch::async, [&] { folds->read_ahead(); });
    ColorRefinement out{std::move(fit), std::move(lens), {}, {}};
    out.exposure = decide_exposure(out.fit, exposure);
    out.vignetting = decide_vignetting(out.fit, vignetting);
    // Unless forced, vignetting is corrected only together with exposure.
    if (!out.exposure.on && vignetting == EffectChoice::automatic) out.vignetting.on = false;
    if (folds && out.exposure.on) {
        FoldColors without = colors_without(*folds, out.lens, out.vignetting.on);
        const ColorJudgments validated = validate_colors(*folds, without.gains, without.both);
        confirm(out.exposure, validated.exposure);
        if (out.vignetting.on) confirm(out.vignetting, validated.vignetting);
        if (!out.exposure.on && vignetting == EffectChoice::automatic) out.vignetting.on = false;
        out.without = std::move(out.vignetting.on ? without.both : without.gains);
    }
    const bool fitted =
        std::ranges::any_of(out.fit.vignetting, [](const Vignetting& f) { return f != Vignetting{}; });
    if (fitted && !out.vignetting.on) out.fit = fit_colors(samples, out.lens, false);
    return out;
}

void apply_colors(const ColorRefinement& r, std::span<package::PhotoRecord> photos) {
    apply_colors(colors_of(r.fit, r.lens), r.exposure.on, r.vignetting.on, photos);
}

}  // namespace vantage
