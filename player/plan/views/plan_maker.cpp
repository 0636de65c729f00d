#include "player/plan/views/plan_maker.h"

#include <algorithm>
#include <utility>

namespace vantage {
namespace {

bool all_current(std::span<const OrderedPlan> views) {
    return std::ranges::all_of(views, [](const OrderedPlan& view) {
        return view.plan->is_current(view.shares ? &view.shares->plan().choice : nullptr);
    });
}

/// Fills `job` with the views' requests.
void fill(PlanJob& job, std::span<const OrderedPlan> views) {
    job.plans.resize(views.size());
    for (std::size_t i = 0; i < views.size(); ++i) {
        job.plans[i].order = views[i].plan->order_to_make();
        job.plans[i].before = views[i].plan->made();
        job.plans[i].shares.reset();
        const auto shared = std::ranges::find(views, views[i].shares, &OrderedPlan::plan);
        if (shared != views.end()) job.plans[i].shares = std::size_t(shared - views.begin());
    }
}

/// Stores plans that match the views' current requests.
void give(std::span<const OrderedPlan> views, const PlanThread::Plans& plans) {
    if (plans.size() != views.size()) return;
    for (std::size_t i = 0; i < plans.size(); ++i)
        if (!suits(*plans[i], views[i].plan->ordered())) return;
    for (std::size_t i = 0; i < plans.size(); ++i) views[i].plan->take(plans[i]);
}

}  // namespace

void PlanMaker::update(std::span<const OrderedPlan> views, bool at_once, const View* next) {
    constexpr unsigned every = 4;  // frames; the predicted view is further ahead
    const bool looks_ahead = next && moves_++ % every == 0;
    if (!next) ahead_.clear();
    take(views, false);
    if (thread_)
        if (auto ahead = thread_->take_ahead()) ahead_ = std::move(*ahead);
    const auto can_stand = [&] {
        return !at_once && std::ranges::all_of(views, &ViewPlan::can_stand, &OrderedPlan::plan);
    };
    current_ = all_current(views);
    if (!current_ && !can_stand()) {
        take(views, true);
        current_ = all_current(views);
    }
    if (!current_ && can_stand()) {
        begin(views, looks_ahead ? next : nullptr, false);
        return;
    }
    if (!current_) {
        fill(job_, views);
        give(views, plans_of(*scene_, job_));
        current_ = true;
    }
    if (looks_ahead) begin(views, next, true);
}

void PlanMaker::take(std::span<const OrderedPlan> views, bool wait) {
    if (!thread_) return;
    if (const auto plans = thread_->take(wait)) give(views, *plans);
}

void PlanMaker::begin(std::span<const OrderedPlan> views, const View* next, bool only_next) {
    if (!thread_) thread_.emplace(*scene_);
    if (thread_->busy()) return;
    fill(job_, views);
    job_.next = next ? std::optional(*next) : std::nullopt;
    job_.only_next = only_next;
    job_ = thread_->begin(std::move(job_));
}

}  // namespace vantage
