#include "player/render/view_plan.h"

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

PlanSettings plan_settings(const RenderSettings& s, int side) {
    PlanSettings p;
    p.choice = s.choice;
    p.photos = s.photos;
    p.tiles = !s.thumbnails;
    p.angle_limit = s.photos > 0 ? s.angle_limit * std::numbers::pi / 180 : 0;
    // Beyond 4 taps, finer levels are read than the footprint that is kept sharp otherwise asks for.
    p.samples = side * std::exp2(-s.lod_bias) * std::max(1.0, s.anisotropy / 4.0);
    if (!s.complete) p.worth = 0.1;  // 47 dB and more from all that may be sampled, for half of the bytes
    const bool falls = s.weights.angle && !s.weights.angle_per_photo && s.show != Show::coverage;
    if (falls && s.blend != Blend::best) p.sharpness = s.weights.sharpness;
    return p;
}

/// What was seen from `before` says what is seen from `now`.
bool shows_much_of(const View& before, const View& now, const PlanScene& scene) {
    const double turned = before.cam_from_origin.direction().dot(now.cam_from_origin.direction());
    const double moved = (before.cam_from_origin.center() - now.cam_from_origin.center()).norm();
    const ClusterTree::Node& all = scene.tree.nodes.front();
    return turned > std::cos(std::numbers::pi / 9) && moved < 0.1 * (all.high - all.low).norm();
}

/// With a pixel more on each side: samples lie up to half a pixel around a pixel's centre.
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

void ViewPlan::update(const View& view, const RenderSettings& settings, std::span<const std::uint32_t> photos,
                      int side, const SeenTriangles& seen) {
    const PlanSettings wanted = plan_settings(settings, side);
    if (made_for_ && same(made_for_->view, view) && made_for_->settings == wanted &&
        std::ranges::equal(made_for_->photos, photos) && made_for_->seen == seen.version())
        return;
    std::vector<std::uint32_t> former = photos_of(plan_.photos);
    knows_seen_ = (!settings.complete || settings.photos > 0) && !seen.triangles().empty() &&
                  shows_much_of(seen.view(), view, *scene_);
    plan_ = make_plan(*scene_, widened(view), wanted, photos, former,
                      knows_seen_ ? seen.triangles() : std::span<const std::uint32_t>());
    plan_leaving(widened(view), settings, photos, std::move(former));
    made_for_ = Key{view, wanted, {photos.begin(), photos.end()}, seen.version()};
}

void ViewPlan::plan_leaving(const View& view, const RenderSettings& settings,
                            std::span<const std::uint32_t> photos, std::vector<std::uint32_t> former) {
    std::ranges::copy(photos_of(leaving_), std::back_inserter(former));
    std::ranges::sort(former);
    former.erase(std::unique(former.begin(), former.end()), former.end());
    const std::vector<std::uint32_t> planned = photos_of(plan_.photos);
    std::erase_if(former, [&](std::uint32_t p) {
        return presence_[p] <= 0 || !std::ranges::count(photos, p) || std::ranges::count(planned, p);
    });
    leaving_.clear();
    if (former.empty() || settings.complete) return;
    PlanSettings all = plan_settings(settings, 1);
    all.photos = 0;
    leaving_ = make_plan(*scene_, view, all, former).photos;
}

void ViewPlan::fade(const RenderSettings& settings, double now, const std::vector<bool>& ready) {
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

std::vector<const PlannedPhoto*> ViewPlan::present(const RenderSettings& settings) const {
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

Plan ViewPlan::ahead(const View& next, const RenderSettings& settings, int side) const {
    return make_plan(*scene_, next, plan_settings(settings, side), photos_of(plan_.photos));
}

}  // namespace vantage
