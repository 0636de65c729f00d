#include "player/plan/views/view_plan.h"

#include <algorithm>
#include <utility>

namespace vantage {
namespace {

constexpr double fade_seconds = 0.3;

}  // namespace

void ViewPlan::order(const View& view, const PlanSettings& settings, std::span<const std::uint32_t> photos,
                     int side, const SeenTriangles& seen) {
    if (ordered_.side == 0 || !same_view(ordered_.view, view) ||
        ordered_.settings.background != settings.background)
        find_clusters(*scene_, with_samples(view), settings.background, in_view_);
    ordered_.view = view;
    ordered_.settings = settings;
    ordered_.side = side;
    ordered_.photos.assign(photos.begin(), photos.end());
    ordered_.seen = seen;
    allowed_.assign(drawn_.size(), false);
    for (const std::uint32_t p : photos) allowed_[p] = true;
    for (std::uint32_t p = 0; p < drawn_.size(); ++p) {
        drawn_[p] = drawn_[p] && allowed_[p];
        before_[p] = before_[p] && allowed_[p];
    }
}

const PlanOrder& ViewPlan::order_to_make() {
    planned_.assign(drawn_.size(), false);
    for (const PlannedPhoto& p : plan().photos) planned_[p.photo] = allowed_[p.photo];
    ordered_.drawn.clear();
    for (std::uint32_t p = 0; p < drawn_.size(); ++p)
        if (drawn_[p] || before_[p] || planned_[p]) ordered_.drawn.push_back(p);
    ordered_.steady = settled() && drawn_ == planned_;
    return ordered_;
}

void ViewPlan::take(std::shared_ptr<const PlannedView> plan) {
    made_ = std::move(plan);
    find_photos();
}

bool ViewPlan::is_current(const PhotoChoice* shared) const {
    return made_ && vantage::is_current(*made_, ordered_, shared);
}

bool ViewPlan::can_stand() const {
    return made_ && can_stand_for(*scene_, *made_, ordered_, in_view_.opaque);
}

void ViewPlan::fade(const PlanSettings& settings, double now, const std::vector<bool>& ready) {
    const bool at_once = std::exchange(reduced_, settings.reduced) || settings.reduced || settings.complete;
    const double step = at_once ? 1 : std::clamp((now - last_) / fade_seconds, 0.0, 1.0);
    last_ = now;
    wanted_.assign(drawn_.size(), false);
    for (const PlannedPhoto& p : plan().photos) wanted_[p.photo] = settings.complete || ready[p.photo];
    progress_ = std::min(1.0, progress_ + step);
    if (settled()) before_ = drawn_;
    if (settled() && wanted_ != drawn_) {
        const bool first = std::ranges::count(drawn_, true) == 0;
        std::swap(drawn_, wanted_);
        progress_ = first ? 1 : step;
        if (settled()) before_ = drawn_;
    }
    find_photos();
}

/// Finds the photos of drawn() and before() in the newest plan.
void ViewPlan::find_photos() {
    planned_.assign(drawn_.size(), false);
    drawn_photos_.clear(), before_photos_.clear();
    for (const PlannedPhoto& p : plan().photos) {
        planned_[p.photo] = true;
        if (drawn_[p.photo]) drawn_photos_.push_back(&p);
    }
    for (const PlannedPhoto& p : kept())
        if (drawn_[p.photo] && !planned_[p.photo]) drawn_photos_.push_back(&p);
    for (const PlannedPhoto& p : kept().empty() ? plan().photos : kept())
        if (before_[p.photo]) before_photos_.push_back(&p);
}

}  // namespace vantage
