#include "player/render/planning/image_set_plans.h"

#include <algorithm>
#include <utility>

namespace vantage {

void ImageSetPlans::choose(const RenderSettings& settings, double now) {
    ShownImageSets wanted = shown_image_sets(settings.image_sets, scene_->image_sets.size());
    if (scene_->image_sets.size() > 1 && !is_complete(settings.loading)) {
        const bool ready = !first_.drawn().empty() || first_.plan().photos.empty();
        wanted = change_.update(wanted, now, ready);
    }
    show(wanted);
}

void ImageSetPlans::show(const ShownImageSets& wanted) {
    if (wanted.first != shown_.first) {
        std::optional<ViewPlan> former(std::move(first_));
        first_ = second_ && shown_.second == wanted.first ? std::move(*second_) : ViewPlan(*scene_);
        second_ = wanted.second == shown_.first ? std::move(former) : std::nullopt;
    } else if (wanted.second != shown_.second) {
        second_.reset();
    }
    if (wanted.second && !second_) second_.emplace(*scene_);
    if (!wanted.second) second_.reset();
    shown_ = wanted;
}

void ImageSetPlans::find_frames(const RenderSettings& settings, std::span<const std::uint32_t> photos,
                                std::vector<ImageSetFrame>& frames) {
    frames.resize(shown_.second ? 2 : 1);
    for (ImageSetFrame& frame : frames) {
        frame.second = &frame != &frames.front();
        frame.plan = frame.second ? &*second_ : &first_;
        const std::uint32_t image_set = frame.second ? *shown_.second : shown_.first;
        frame.settings = settings;
        choose_image_set(frame.settings, image_set, *scene_);
        frame.photos.clear();
        const bool compares = settings.compare != Compare::nothing;
        for (const std::uint32_t p : photos)
            if (scene_->photos[p].image_set == image_set && !(compares && p == settings.compare_photo))
                frame.photos.push_back(p);
    }
}

bool ImageSetPlans::uses(std::uint32_t photo) const {
    const auto among = [&](const std::vector<PlannedPhoto>& photos) {
        return std::ranges::count(photos, photo, &PlannedPhoto::photo) > 0;
    };
    const auto has = [&](const Plan& plan) { return among(plan.photos) || among(plan.behind); };
    return has(first_.plan()) || (second_ && has(second_->plan()));
}

bool ImageSetPlans::settled() const {
    return change_.settled() && first_.settled() && (!second_ || second_->settled());
}

}  // namespace vantage
