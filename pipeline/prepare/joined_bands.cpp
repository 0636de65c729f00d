#include "pipeline/prepare/joined_bands.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <tuple>
#include <utility>

#include "base/values/bytes_of.h"

namespace vantage {
namespace {

template <class Result>
std::vector<EffectDecision> decisions_of(const std::vector<Result>& bands, EffectDecision Result::*member) {
    std::vector<EffectDecision> out;
    for (const Result& b : bands) out.push_back(b.*member);
    return out;
}

/// Per photo, the value of its own band.
template <class Result, class Value>
std::vector<Value> own_values(const std::vector<Result>& bands, std::vector<Value> Result::*member,
                              std::span<const package::PhotoRecord> photos) {
    std::vector<Value> out;
    for (std::size_t i = 0; i < photos.size(); ++i) out.push_back((bands[photos[i].band].*member)[i]);
    return out;
}

bool is_of(const PoseWithout& p, std::uint32_t band, std::span<const package::PhotoRecord> photos) {
    return photos[p.without].band == band && photos[p.photo].band == band;
}

/// What does not differ per photo: a lens belongs to one band.
ColorFit joined_fit(const std::vector<ColorFit>& bands, std::span<const std::uint32_t> lens,
                    std::span<const package::PhotoRecord> photos) {
    ColorFit out = bands.front();
    out.ln_gain = own_values(bands, &ColorFit::ln_gain, photos);
    out.component = own_values(bands, &ColorFit::component, photos);
    out.samples = own_values(bands, &ColorFit::samples, photos);
    out.photo_before = own_values(bands, &ColorFit::photo_before, photos);
    out.photo_after = own_values(bands, &ColorFit::photo_after, photos);
    for (std::size_t i = 0; i < photos.size(); ++i)
        out.falloff[lens[i]] = bands[photos[i].band].falloff[lens[i]];
    for (const ColorFit& b : bands)
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
        // Of bands that have the effect, if any has.
        if (d.on == out.on ? d.measured > out.measured : d.on) out.measured = d.measured;
        out.on |= d.on;
        out.evidence += (b ? "; " : "") + names[b] + ": " + d.evidence;
        out.bands.push_back({names[b], d.on, d.measured, d.evidence, d.judgment});
    }
    return out;
}

Registration joined(std::vector<Registration> bands, std::span<const package::PhotoRecord> photos,
                    std::span<const std::string> names) {
    if (bands.size() == 1) return std::move(bands.front());
    Registration out;
    out.decision = joined(decisions_of(bands, &Registration::decision), names);
    out.photos = own_values(bands, &Registration::photos, photos);
    for (std::uint32_t b = 0; b < bands.size(); ++b) {
        out.pairs.insert(out.pairs.end(), bands[b].pairs.begin(), bands[b].pairs.end());
        for (const PoseWithout& p : bands[b].without)
            if (is_of(p, b, photos)) out.without.push_back(p);
        for (const std::string& w : bands[b].warnings) out.warnings.push_back(names[b] + ": " + w);
    }
    std::ranges::sort(out.pairs, {}, [](const package::PairRecord& p) { return std::pair(p.a, p.b); });
    std::ranges::sort(out.without, {}, [](const PoseWithout& p) { return std::pair(p.without, p.photo); });
    return out;
}

ColorRefinement joined(std::vector<ColorRefinement> bands, std::span<const package::PhotoRecord> photos,
                       std::span<const std::string> names) {
    if (bands.size() == 1) return std::move(bands.front());
    std::vector<ColorFit> fits;
    for (ColorRefinement& b : bands) fits.push_back(std::move(b.fit));
    return {joined_fit(fits, bands.front().lens, photos), bands.front().lens,
            joined(decisions_of(bands, &ColorRefinement::exposure), names),
            joined(decisions_of(bands, &ColorRefinement::falloff), names)};
}

Consensus joined(std::vector<Consensus> bands, std::span<const package::PhotoRecord> photos,
                 std::span<const std::string> names) {
    if (bands.size() == 1) return std::move(bands.front());
    return {joined(decisions_of(bands, &Consensus::decision), names),
            own_values(bands, &Consensus::disagreeing, photos)};
}

std::vector<EffectSet> effects_of_bands(const Agreement& agreement, std::size_t bands) {
    std::vector<EffectSet> out(bands, 0);
    for (const EffectDecision* d : {&agreement.registration.decision, &agreement.colors.exposure,
                                    &agreement.colors.falloff, &agreement.consensus.decision})
        for (std::size_t b = 0; b < bands; ++b)
            if (d->bands.empty() ? d->on : b < d->bands.size() && d->bands[b].on)
                out[b] |= effect_bit(d->effect);
    if (agreement.surroundings.on) out.front() |= effect_bit(Effect::surroundings);
    return out;
}

void write_bands(PackageWriter& writer, std::span<const std::string> names,
                 std::span<const EffectSet> effects) {
    if (names.size() < 2) return;
    std::vector<package::BandRecord> records(names.size(), package::BandRecord{});
    for (std::size_t b = 0; b < names.size(); ++b) {
        std::memcpy(records[b].name, names[b].data(), std::min(names[b].size(), sizeof records[b].name - 1));
        if (b < effects.size()) records[b].effects = effects[b];
    }
    writer.write(package::Type::bands, package::scene_wide, bytes_of(records));
}

}  // namespace vantage
