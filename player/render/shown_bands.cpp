#include "player/render/shown_bands.h"

#include <algorithm>

#include "player/plan/selection/weights.h"

namespace vantage {
namespace {

constexpr double fade_seconds = 0.3, longest_wait = 3;

}  // namespace

ShownBands shown_bands(const BandSettings& s, std::size_t bands) {
    ShownBands out{s.shown < bands ? s.shown : 0, {}, s.how, s.how == BandView::mix ? s.share : s.wiper};
    if (!s.other || *s.other >= bands || *s.other == out.first) return out;
    if (s.how == BandView::mix && !(s.share > 0)) return out;
    if (s.how == BandView::mix && s.share >= 1) return {*s.other, {}, s.how, 0};
    out.second = s.other;
    return out;
}

RenderSettings settings_of_band(RenderSettings settings, std::uint32_t band, const PlanScene& scene) {
    settings.bands = {.shown = band};
    if (band == 0 || !scene.has_surroundings()) return settings;
    const bool shown = settings.surroundings != ShowSurroundings::off;
    settings.surroundings = ShowSurroundings::off;
    // As with surroundings: a change of bands must not need other data of the photos.
    if (shown && settings.coordinates == Coordinates::automatic) settings.coordinates = Coordinates::fragment;
    return settings;
}

std::vector<std::uint32_t> photos_of_band(std::span<const std::uint32_t> photos, std::uint32_t band,
                                          const PlanScene& scene) {
    std::vector<std::uint32_t> out(photos.begin(), photos.end());
    std::erase_if(out, [&](std::uint32_t p) { return scene.photos[p].band != band; });
    return out;
}

std::vector<double> weights_in_band(const View& view, const WeightSettings& settings, std::uint32_t band,
                                    const PlanScene& scene) {
    if (scene.bands.size() == 1) return dynamic_weights(view, scene.photos, settings);
    std::vector<package::PhotoRecord> own;
    for (const package::PhotoRecord& p : scene.photos)
        if (p.band == band) own.push_back(p);
    const std::vector<double> weights = dynamic_weights(view, own, settings);
    std::vector<double> out(scene.photos.size(), 1);
    for (std::size_t i = 0, next = 0; i < out.size(); ++i)
        if (scene.photos[i].band == band) out[i] = weights[next++];
    return out;
}

ShownBands BandChange::update(ShownBands wanted, double now, bool ready) {
    if (shown_ && *shown_ != wanted.first && !wanted.second) {
        // Back to the band that leaves: at once, for its photos are there.
        leaving_ = leaving_ == wanted.first ? std::nullopt : shown_;
        begun_ = now;
        ready_at_.reset();
        ready = false;
    }
    shown_ = wanted.first;
    if (wanted.second || !leaving_) {
        leaving_.reset();
        return wanted;
    }
    if (!ready_at_ && (ready || now - begun_ > longest_wait)) ready_at_ = now;
    const double share = ready_at_ ? 1 - (now - *ready_at_) / fade_seconds : 1;
    if (!(share > 0)) {
        leaving_.reset();
        return wanted;
    }
    return {wanted.first, leaving_, BandView::mix, std::min(share, 1.0)};
}

}  // namespace vantage
