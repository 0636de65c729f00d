#pragma once
#include <optional>
#include <span>
#include <vector>

#include "player/plan/views/plan_thread.h"
#include "player/plan/views/view_plan.h"

namespace vantage {

/// A plan that a view of the frame has ordered.
struct OrderedPlan {
    ViewPlan* plan;
    const ViewPlan* shares = nullptr;  ///< whose photos it has; null: it chooses its own
};

/// Makes the plans of frames: on a thread of its own if the frame can be drawn with those of the frame
/// before, so that it need not wait; else at once.
class PlanMaker {
  public:
    /// `scene` must outlive it.
    explicit PlanMaker(const PlanScene& scene) : scene_(&scene) {}

    /// Makes what the frame's views have ordered, those whose photos others share first. `at_once`: before
    /// this returns. `next`: the view expected next, whose tiles are planned, too; null: none.
    void update(std::span<const OrderedPlan> views, bool at_once, const View* next);
    /// Whether the views have the plans that they ordered.
    bool current() const { return current_; }
    /// The photos of the view expected next, with their tiles.
    std::span<const PlannedPhoto> ahead() const { return ahead_; }

  private:
    void take(std::span<const OrderedPlan> views, bool wait);
    /// Unless the thread is still at other plans.
    void begin(std::span<const OrderedPlan> views, const View* next, bool only_next);

    const PlanScene* scene_;
    std::optional<PlanThread> thread_;
    PlanJob job_;  ///< kept for its memory
    std::vector<PlannedPhoto> ahead_;
    bool current_ = false;
    unsigned moves_ = 0;  ///< frames with a view to come
};

}  // namespace vantage
