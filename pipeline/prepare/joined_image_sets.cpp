#include "pipeline/prepare/joined_image_sets.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <tuple>
#include <utility>

#include "base/values/bytes_of.h"

namespace vantage {
namespace {

template <class Result>
std::vector<EffectDecision> decisions_of(const std::vector<Result>& image_sets,
                                         EffectDecision Result::*member) {
    std::vector<EffectDecision> out;
    for (const Result& b : image_sets) out.push_back(b.*member);
    return out;
}

/// For each photo, the value from its own image set.
template <class Result, class Value>
std::vector<Value> own_values(const std::vector<Result>& image_sets, std::vector<Value> Result::*member,
                              std::span<const package::PhotoRecord> photos) {
    std::vector<Value> out;
    for (std::size_t i = 0; i < photos.size(); ++i)
        out.push_back((image_sets[photos[i].image_set].*member)[i]);
    return out;
}

bool is_of(const LeaveOneOutPose& p, std::uint32_t image_set, std::span<const package::PhotoRecord> photos) {
    return photos[p.without].image_set == image_set && photos[p.photo].image_set == image_set;
}

/// Joins the values per lens: each lens belongs to one image set only.
ColorFit joined_fit(const std::vector<ColorFit>& image_sets, std::span<const std::uint32_t> lens,
                    std::span<const package::PhotoRecord> photos) {
    ColorFit out = image_sets.front();
    out.ln_gain = own_values(image_sets, &ColorFit::ln_gain, photos);
    out.component = own_values(image_sets, &ColorFit::component, photos);
    out.samples = own_values(image_sets, &ColorFit::samples, photos);
    out.photo_before = own_values(image_sets, &ColorFit::photo_before, photos);
    out.photo_after = own_values(image_sets, &ColorFit::photo_after, photos);
    for (std::size_t i = 0; i < photos.size(); ++i)
        out.vignetting[lens[i]] = image_sets[photos[i].image_set].vignetting[lens[i]];
    for (const ColorFit& b : image_sets)
        if (b.before > out.before) out.before = b.before, out.after = b.after;
    return out;
}

}  // namespace

EffectDecision joined(std::span<const EffectDecision> decisions, std::span<const std::string> names) {
    EffectDecision out = decisions.front();
    if (decisions.size() == 1) return out;
    out = {out.effect, false, out.forced, 0, {}};
    for (std::size_t b = 0; b < decisions.size(); ++b) {
        const EffectDecision& d = decisions[b];
        // The maximum over the image sets for which the effect is on, or over all image sets if the effect is
        // off for all of them.
        if (d.on == out.on ? d.measured > out.measured : d.on) out.measured = d.measured;
        out.on |= d.on;
        out.evidence += (b ? "; " : "") + names[b] + ": " + d.evidence;
        out.image_sets.push_back({names[b], d.on, d.measured, d.evidence, d.judgment});
    }
    return out;
}

PoseRefinement joined(std::vector<PoseRefinement> image_sets, std::span<const package::PhotoRecord> photos,
                      std::span<const std::string> names) {
    if (image_sets.size() == 1) return std::move(image_sets.front());
    PoseRefinement out;
    out.decision = joined(decisions_of(image_sets, &PoseRefinement::decision), names);
    out.photos = own_values(image_sets, &PoseRefinement::photos, photos);
    for (std::uint32_t b = 0; b < image_sets.size(); ++b) {
        out.pairs.insert(out.pairs.end(), image_sets[b].pairs.begin(), image_sets[b].pairs.end());
        for (const LeaveOneOutPose& p : image_sets[b].without)
            if (is_of(p, b, photos)) out.without.push_back(p);
        for (const std::string& w : image_sets[b].warnings) out.warnings.push_back(names[b] + ": " + w);
    }
    std::ranges::sort(out.pairs, {}, [](const package::PairRecord& p) { return std::pair(p.a, p.b); });
    std::ranges::sort(out.without, {},
                      [](const LeaveOneOutPose& p) { return std::pair(p.without, p.photo); });
    return out;
}

ColorRefinement joined(std::vector<ColorRefinement> image_sets, std::span<const package::PhotoRecord> photos,
                       std::span<const std::string> names) {
    if (image_sets.size() == 1) return std::move(image_sets.front());
    std::vector<ColorFit> fits;
    for (ColorRefinement& b : image_sets) fits.push_back(std::move(b.fit));
    return {joined_fit(fits, image_sets.front().lens, photos), image_sets.front().lens,
            joined(decisions_of(image_sets, &ColorRefinement::exposure), names),
            joined(decisions_of(image_sets, &ColorRefinement::vignetting), names)};
}

TransientMasks joined(std::vector<TransientMasks> image_sets, std::span<const package::PhotoRecord> photos,
                      std::span<const std::string> names) {
    if (image_sets.size() == 1) return std::move(image_sets.front());
    return {joined(decisions_of(image_sets, &TransientMasks::decision), names),
            own_values(image_sets, &TransientMasks::disagreeing, photos)};
}

std::vector<EffectSet> effects_of_image_sets(std::span<const EffectDecision> decisions,
                                             std::size_t image_sets) {
    std::vector<EffectSet> out(image_sets, 0);
    for (const EffectDecision& d : decisions)
        for (std::size_t b = 0; b < image_sets; ++b) {
            const bool decided = d.image_sets.empty() ? d.on : b < d.image_sets.size() && d.image_sets[b].on;
            // Only the first image set has a background.
            if (decided && (b == 0 || d.effect != Effect::background)) out[b] |= effect_bit(d.effect);
        }
    return out;
}

void write_image_sets(PackageWriter& writer, std::span<const std::string> names,
                      std::span<const EffectSet> effects) {
    if (names.size() < 2) return;
    std::vector<package::ImageSetRecord> records(names.size(), package::ImageSetRecord{});
    for (std::size_t b = 0; b < names.size(); ++b) {
        std::memcpy(records[b].name, names[b].data(), std::min(names[b].size(), sizeof records[b].name - 1));
        if (b < effects.size()) records[b].effects = effects[b];
    }
    writer.write(package::Type::image_sets, package::scene_wide, bytes_of(records));
}

}  // namespace vantage
