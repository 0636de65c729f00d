#include "player/plan/view_plan.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vantage {
namespace {

constexpr double fade_seconds = 0.3;

bool same(const View& a, const View& b) {
    const Intrinsics &k = a.intrinsics, &l = b.intrinsics;
    return k.width == l.width && k.height == l.height && k.fx == l.fx && k.fy == l.fy && k.cx == l.cx &&
           k.cy == l.cy && a.cam_from_origin.R == b.cam_from_origin.R &&
           a.cam_from_origin.t == b.cam_from_origin.t;
}

PlanSettings with_side(PlanSettings settings, int side) {
    settings.samples *= side;
    return settings;
}

/// Whether the surface seen from `before` is a good guess for `now`: turned by at most 20 degrees, moved by
/// at most a tenth of the model's diagonal.
bool shows_much_of(const View& before, const View& now, const PlanScene& scene) {
    const double turned = before.cam_from_origin.direction().dot(now.cam_from_origin.direction());
    const double moved = (before.cam_from_origin.center() - now.cam_from_origin.center()).norm();
    const ClusterTree::Node& all = scene.tree.nodes.front();
    return turned > std::cos(std::numbers::pi / 9) && moved < 0.1 * (all.high - all.low).norm();
}

/// One pixel wider on each side: samples lie up to half a pixel from a pixel's center.
View widened(View view) {
    view.intrinsics.width += 2;
    view.intrinsics.height += 2;
    view.intrinsics.cx += 1;
    view.intrinsics.cy += 1;
    return view;
}

std::vector<std::uint32_t> photos_of(const std::vector<PlannedPhoto>& planned) {
    std::vector<std::uint32_t> out;
    for (const PlannedPhoto& p : planned) out.push_back(p.photo);
    return out;
}

}  // namespace

void ViewPlan::update(const View& view, const PlanSettings& settings, std::span<const std::uint32_t> photos,
                      int side, const SeenTriangles& seen) {
    const PlanSettings wanted = with_side(settings, side);
    if (made_for_ && same(made_for_->view, view) && made_for_->settings == wanted &&
        std::ranges::equal(made_for_->photos, photos) && made_for_->seen == seen.version)
        return;
    std::vector<std::uint32_t> previous = photos_of(plan_.photos);
    uses_seen_ = (!settings.complete || settings.photos > 0) && !seen.triangles.empty() &&
                 shows_much_of(seen.view, view, *scene_);
    plan_ = make_plan(*scene_, widened(view), wanted, photos, previous,
                      uses_seen_ ? seen.triangles : std::span<const std::uint32_t>());
    plan_leaving(widened(view), settings, photos, std::move(previous));
    made_for_ = Key{view, wanted, {photos.begin(), photos.end()}, seen.version};
}

void ViewPlan::plan_leaving(const View& view, const PlanSettings& settings,
                            std::span<const std::uint32_t> photos, std::vector<std::uint32_t> previous) {
    std::ranges::copy(photos_of(leaving_), std::back_inserter(previous));
    std::ranges::sort(previous);
    previous.erase(std::unique(previous.begin(), previous.end()), previous.end());
    const std::vector<std::uint32_t> planned = photos_of(plan_.photos);
    std::erase_if(previous, [&](std::uint32_t p) {
        return presence_[p] <= 0 || !std::ranges::count(photos, p) || std::ranges::count(planned, p);
    });
    leaving_.clear();
    if (previous.empty() || settings.complete) return;
    PlanSettings all = settings;
    all.photos = 0;
    leaving_ = make_plan(*scene_, view, all, previous).photos;
}

void ViewPlan::fade(const PlanSettings& settings, double now, const std::vector<bool>& ready) {
    const auto step = float(std::clamp((now - last_) / fade_seconds, 0.0, 1.0));
    last_ = now;
    std::vector<bool> stays(presence_.size(), false);
    const bool first = std::ranges::all_of(presence_, [](float p) { return p == 0; });
    for (const PlannedPhoto& p : plan_.photos) stays[p.photo] = settings.complete || ready[p.photo];
    for (std::size_t i = 0; i < presence_.size(); ++i) {
        presence_[i] = std::clamp(presence_[i] + (stays[i] ? step : -step), 0.0f, 1.0f);
        if (settings.complete || (first && stays[i])) presence_[i] = stays[i];
    }
    std::erase_if(leaving_, [&](const PlannedPhoto& p) { return presence_[p.photo] <= 0; });
}

std::vector<const PlannedPhoto*> ViewPlan::present(const PlanSettings& settings) const {
    std::vector<const PlannedPhoto*> out;
    for (const PlannedPhoto& p : plan_.photos)
        if (settings.complete || presence_[p.photo] > 0) out.push_back(&p);
    for (const PlannedPhoto& p : leaving_)
        if (presence_[p.photo] > 0) out.push_back(&p);
    return out;
}

bool ViewPlan::settled() const {
    return leaving_.empty() && std::ranges::all_of(presence_, [](float p) { return p == 0 || p == 1; });
}

Plan ViewPlan::ahead(const View& next, const PlanSettings& settings, int side) const {
    return make_plan(*scene_, next, with_side(settings, side), photos_of(plan_.photos));
}

}  // namespace vantage
