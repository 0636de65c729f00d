#include "player/render/planning/shown_image_sets.h"

#include <algorithm>

#include "player/plan/selection/weights.h"

namespace vantage {
namespace {

constexpr double fade_seconds = 0.3, longest_wait = 3;

}  // namespace

ShownImageSets shown_image_sets(const ImageSetSettings& s, std::size_t image_sets) {
    ShownImageSets out{
        s.shown < image_sets ? s.shown : 0, {}, s.how, s.how == ImageSetView::mix ? s.share : s.swipe};
    if (!s.other || *s.other >= image_sets || *s.other == out.first) return out;
    if (s.how == ImageSetView::mix && !(s.share > 0)) return out;
    if (s.how == ImageSetView::mix && s.share >= 1) return {*s.other, {}, s.how, 0};
    out.second = s.other;
    return out;
}

void choose_image_set(RenderSettings& settings, std::uint32_t image_set, const PlanScene& scene) {
    settings.image_sets = {.shown = image_set};
    if (image_set == 0 || !scene.has_background()) return;
    const bool shown = settings.background != ShowBackground::off;
    settings.background = ShowBackground::off;
    // Coordinates are chosen as if there were a background, so that a change of image sets requires no
    // additional data of the photos.
    if (shown && settings.coordinates == Coordinates::automatic) settings.coordinates = Coordinates::fragment;
}

std::vector<double> weights_in_image_set(const View& view, const WeightSettings& settings,
                                         std::uint32_t image_set, const PlanScene& scene) {
    if (scene.image_sets.size() == 1) return dynamic_weights(view, scene.photos, settings);
    std::vector<package::PhotoRecord> own;
    for (const package::PhotoRecord& p : scene.photos)
        if (p.image_set == image_set) own.push_back(p);
    const std::vector<double> weights = dynamic_weights(view, own, settings);
    std::vector<double> out(scene.photos.size(), 1);
    for (std::size_t i = 0, next = 0; i < out.size(); ++i)
        if (scene.photos[i].image_set == image_set) out[i] = weights[next++];
    return out;
}

ShownImageSets ImageSetChange::update(ShownImageSets wanted, double now, bool ready) {
    if (shown_ && *shown_ != wanted.first && !wanted.second) {
        // Returning to the previous image set requires no waiting, since its photos are loaded.
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
    return {wanted.first, leaving_, ImageSetView::mix, std::min(share, 1.0)};
}

}  // namespace vantage
