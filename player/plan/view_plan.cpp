#include "player/plan/view_plan.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vantage {
namespace {

constexpr double fade_seconds = 0.3;

PlanSettings with_side(PlanSettings settings, int side) {
    settings.samples *= side;
    return settings;
}

/// The eye, or the middle of an orthographic picture, whose eye is far away.
Eigen::Vector3d place_of(const View& view) {
    return view.cam_from_origin.center() + view.orthographic_depth * view.cam_from_origin.direction();
}

/// Whether the surface seen from `before` is a good guess for `now`: turned by at most 20 degrees, moved by
/// at most a tenth of the model's diagonal.
bool shows_much_of(const View& before, const View& now, const PlanScene& scene) {
    const double turned = before.cam_from_origin.direction().dot(now.cam_from_origin.direction());
    const double moved = (place_of(before) - place_of(now)).norm();
    return turned > std::cos(std::numbers::pi / 9) && moved < 0.1 * scene.size;
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
                      int side, const SeenTriangles& seen, const PhotoChoice* shared) {
    const bool unmoved = made_for_ && same_view(made_for_->view, view),
               same_settings = made_for_ && made_for_->settings == settings,
               same_photos = made_for_ && std::ranges::equal(made_for_->photos, photos);
    const bool at_rest = unmoved && same_settings && !at_rest_.empty();
    const bool chosen_here =
        shared ? shared->photos == plan_.choice.photos : chosen_for_ && same_view(*chosen_for_, view);
    if (unmoved && same_settings && same_photos && chosen_here && made_for_->side == side &&
        (at_rest || made_for_->seen == seen.version))
        return;
    const std::vector<std::uint32_t> previous = photos_of(plan_.photos);
    if (!at_rest) {
        uses_seen_ = !seen.triangles.empty() && shows_much_of(seen.view, view, *scene_);
        at_rest_.clear();
        // After other settings, the triangles may be from before the change.
        if (uses_seen_ && same_settings && same_view(seen.view, view))
            at_rest_.assign(seen.triangles.begin(), seen.triangles.end());
    }
    const bool moves = same_settings && same_photos && !unmoved && !settings.complete;
    const PhotoChoice choice = std::move(plan_.choice);
    const bool keeps = !shared && keeps_choice(view, moves);
    std::span<const std::uint32_t> known = at_rest_;
    if (uses_seen_ && known.empty()) known = seen.triangles;
    if (keeps) shared = &choice;
    const Seen pixels{known, known.empty() || !seen.at_pixels ? nullptr
                             : at_rest_.empty()               ? &seen.view
                                                              : &view};
    plan_ = make_plan(*scene_, widened(view), with_side(settings, side), photos, {previous, pixels, shared});
    plan_drawn(widened(view), settings, photos);
    made_for_ = Key{view, settings, side, {photos.begin(), photos.end()}, seen.version};
}

/// In motion, photos are chosen anew in every third plan only: choosing takes as long as all the rest.
bool ViewPlan::keeps_choice(const View& view, bool moves) {
    constexpr int max_plans = 3;
    const bool keeps = moves && uses_seen_ && chosen_for_ && shows_much_of(*chosen_for_, view, *scene_) &&
                       plans_of_choice_ < max_plans;
    plans_of_choice_ = keeps ? plans_of_choice_ + 1 : 1;
    if (!keeps) chosen_for_ = view;
    return keeps;
}

/// Plans the photos that are drawn as a set of their own: in the plan of others, clusters may lack photos
/// that those outweigh.
void ViewPlan::plan_drawn(const View& view, const PlanSettings& settings,
                          std::span<const std::uint32_t> photos) {
    kept_.clear();
    std::vector<bool> planned(drawn_.size(), false);
    for (const PlannedPhoto& p : plan_.photos) planned[p.photo] = true;
    std::vector<std::uint32_t> drawn;
    for (std::uint32_t p = 0; p < drawn_.size(); ++p) {
        const bool allowed = std::ranges::count(photos, p) > 0;
        drawn_[p] = drawn_[p] && allowed;
        before_[p] = before_[p] && allowed;
        if (drawn_[p] || before_[p]) drawn.push_back(p);
    }
    if (drawn.empty() || settings.complete || (settled() && drawn_ == planned)) return;
    PlanSettings all = settings;
    all.photos = 0;
    all.background = false;  // it does not change with the photos of the mesh
    kept_ = make_plan(*scene_, view, all, drawn).photos;
}

void ViewPlan::fade(const PlanSettings& settings, double now, const std::vector<bool>& ready) {
    const double step =
        settings.complete || settings.reduced ? 1 : std::clamp((now - last_) / fade_seconds, 0.0, 1.0);
    last_ = now;
    std::vector<bool> wanted(drawn_.size(), false);
    for (const PlannedPhoto& p : plan_.photos) wanted[p.photo] = settings.complete || ready[p.photo];
    progress_ = std::min(1.0, progress_ + step);
    if (settled()) before_ = drawn_;
    if (!settled() || wanted == drawn_) return;
    const bool first = std::ranges::count(drawn_, true) == 0;
    drawn_ = std::move(wanted);
    progress_ = first ? 1 : step;
    if (settled()) before_ = drawn_;
}

std::vector<const PlannedPhoto*> ViewPlan::drawn() const {
    std::vector<const PlannedPhoto*> out;
    std::vector<bool> planned(drawn_.size(), false);
    for (const PlannedPhoto& p : plan_.photos) {
        planned[p.photo] = true;
        if (drawn_[p.photo]) out.push_back(&p);
    }
    for (const PlannedPhoto& p : kept_)
        if (drawn_[p.photo] && !planned[p.photo]) out.push_back(&p);
    return out;
}

std::vector<const PlannedPhoto*> ViewPlan::before() const {
    if (settled()) return drawn();
    std::vector<const PlannedPhoto*> out;
    for (const PlannedPhoto& p : kept_)
        if (before_[p.photo]) out.push_back(&p);
    return out;
}

Plan ViewPlan::ahead(const View& next, const PlanSettings& settings, int side) const {
    return make_plan(*scene_, next, with_side(settings, side), photos_of(plan_.photos));
}

}  // namespace vantage
