#pragma once
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "player/plan/views/planned_view.h"

namespace vantage {

/// The clusters in view, the newest plan for the view, and the transition from the previously drawn photos to
/// those of the plan. During a transition both sets are drawn, each blended separately at full weight, and
/// the two pictures are mixed: fading a single photo's weight would make a dominant photo appear in the first
/// frame and disappear in the last one.
class ViewPlan {
  public:
    explicit ViewPlan(const PlanScene& scene)
        : scene_(&scene), drawn_(scene.photos.size(), false), before_(drawn_) {}

    /// Finds the clusters in view and requests a plan. From this call on, only `photos` are drawn.
    void order(const View& view, const PlanSettings& settings, std::span<const std::uint32_t> photos,
               int side, const SeenTriangles& seen);
    const PlanOrder& ordered() const { return ordered_; }
    /// Returns ordered() after adding the photos that frames may draw until the plan is made.
    const PlanOrder& order_to_make();
    /// Whether the newest plan is the requested one, see is_current().
    bool is_current(const PhotoChoice* shared = nullptr) const;
    /// Whether frames can be drawn with the newest plan until the requested one is made.
    bool can_stand() const;
    /// The newest plan; null: none.
    const std::shared_ptr<const PlannedView>& made() const { return made_; }
    void take(std::shared_ptr<const PlannedView> plan);

    /// Advances the transition to `now` seconds. After its end, the next transition starts if the `ready`
    /// photos of the plan (one flag per photo) differ from the drawn photos. If no photos were drawn before,
    /// or if this or the last frame is reduced, the ready photos are shown without a transition.
    void fade(const PlanSettings& settings, double now, const std::vector<bool>& ready);

    const ClustersInView& in_view() const { return in_view_; }
    const Plan& plan() const { return made_ ? made_->plan : no_plan_; }
    /// The photos to draw: planned photos by decreasing agreement, then photos that are no longer planned.
    std::span<const PlannedPhoto* const> drawn() const { return drawn_photos_; }
    /// The photos that are replaced by those of drawn(); the same as drawn() if no transition is in progress.
    std::span<const PlannedPhoto* const> before() const { return settled() ? drawn_photos_ : before_photos_; }
    /// Weight of drawn() in the picture, in [0, 1]; 1: no transition is in progress.
    double progress() const { return progress_; }
    /// See PlannedView.
    const std::vector<PlannedPhoto>& kept() const { return made_ ? made_->kept : no_plan_.photos; }
    bool uses_seen() const { return made_ && made_->uses_seen; }
    /// Whether no transition is in progress.
    bool settled() const { return progress_ >= 1; }

  private:
    void find_photos();

    const PlanScene* scene_;
    PlanOrder ordered_;
    ClustersInView in_view_;
    std::shared_ptr<const PlannedView> made_;
    Plan no_plan_;
    std::vector<bool> drawn_, before_;              ///< per photo; equal if no transition is in progress
    std::vector<bool> allowed_, planned_, wanted_;  ///< per photo
    std::vector<const PlannedPhoto*> drawn_photos_, before_photos_;  ///< of `made_`
    double progress_ = 1, last_ = 0;                                 ///< `last_` in seconds
    bool reduced_ = false;                                           ///< the last frame was reduced
};

}  // namespace vantage
