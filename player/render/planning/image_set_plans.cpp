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

std::vector<ImageSetFrame> ImageSetPlans::frames(const RenderSettings& settings,
                                                 std::span<const std::uint32_t> photos) {
    const auto frame = [&](std::uint32_t image_set, ViewPlan& plan, bool second) {
        return ImageSetFrame{settings_of_image_set(settings, image_set, *scene_),
                             photos_of_image_set(photos, image_set, *scene_), &plan, second};
    };
    std::vector<ImageSetFrame> out{frame(shown_.first, first_, false)};
    if (shown_.second) out.push_back(frame(*shown_.second, *second_, true));
    return out;
}

std::vector<const ViewPlan*> ImageSetPlans::plans() const {
    std::vector<const ViewPlan*> out{&first_};
    if (second_) out.push_back(&*second_);
    return out;
}

bool ImageSetPlans::uses(std::uint32_t photo) const {
    return std::ranges::any_of(plans(), [&](const ViewPlan* p) {
        const auto among = [&](const std::vector<PlannedPhoto>& photos) {
            return std::ranges::count(photos, photo, &PlannedPhoto::photo) > 0;
        };
        return among(p->plan().photos) || among(p->plan().behind);
    });
}

bool ImageSetPlans::settled() const {
    return change_.settled() && std::ranges::all_of(plans(), [](const ViewPlan* p) { return p->settled(); });
}

}  // namespace vantage
