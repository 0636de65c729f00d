#pragma once
#include <optional>
#include <span>
#include <vector>

#include "player/plan/views/plan_thread.h"
#include "player/plan/views/view_plan.h"

namespace vantage {

/// A plan requested by a view of the frame.
struct OrderedPlan {
    ViewPlan* plan;
    const ViewPlan* shares = nullptr;  ///< the plan whose photos are used; null: `plan` chooses its own
};

/// Makes the plans of frames: on a separate thread if the frame can be drawn with the previous plans;
/// otherwise immediately.
class PlanMaker {
  public:
    /// `scene` must outlive the plan maker.
    explicit PlanMaker(const PlanScene& scene) : scene_(&scene) {}

    /// Makes the plans requested by the frame's views; views whose photos are shared come first. `at_once`:
    /// makes the plans before returning. `next`: the next expected view, whose tiles are planned as well;
    /// null: none.
    void update(std::span<const OrderedPlan> views, bool at_once, const View* next);
    /// Abandons the plans that a thread is making; a new thread starts when needed.
    void stop_thread() { thread_.reset(); }
    /// Whether the views have their requested plans.
    bool current() const { return current_; }
    /// The photos of the next expected view, with their tiles.
    std::span<const PlannedPhoto> ahead() const { return ahead_; }

  private:
    void take(std::span<const OrderedPlan> views, bool wait);
    /// Does nothing while the thread is busy.
    void begin(std::span<const OrderedPlan> views, const View* next, bool only_next);

    const PlanScene* scene_;
    std::optional<PlanThread> thread_;
    PlanJob job_;  ///< a job whose memory is reused
    std::vector<PlannedPhoto> ahead_;
    bool current_ = false;
    unsigned moves_ = 0;  ///< number of frames with a predicted view
};

}  // namespace vantage
