#pragma once
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "player/plan/views/planned_view.h"

namespace vantage {

/// Plans that are made together.
struct PlanJob {
    struct One {
        PlanOrder order;
        std::shared_ptr<const PlannedView> before;  ///< null: none
        std::optional<std::size_t> shares{};        ///< the job's plan whose photos this one has
    };
    std::vector<One> plans;
    /// The view expected next: its tiles are prefetched.
    std::optional<View> next{};
    bool only_next = false;  ///< the plans themselves are there
};

/// The plans of a job, in its order. A pure function.
std::vector<std::shared_ptr<const PlannedView>> plans_of(const PlanScene& scene, const PlanJob& job);

/// Makes plans on a thread of its own, so that frames do not wait for them. The scene must outlive it.
class PlanThread {
  public:
    using Plans = std::vector<std::shared_ptr<const PlannedView>>;

    explicit PlanThread(const PlanScene& scene);
    /// Whether a job's plans have not been taken yet.
    bool busy() const { return busy_; }
    /// Begins a job. Must not be busy. Returns one that is done, or an empty one, for its memory.
    PlanJob begin(PlanJob job);
    /// The plans, once, when they are made; `wait` waits for them. Throws what making them has thrown.
    std::optional<Plans> take(bool wait);
    /// Photos to prefetch, once for each job that asks for them.
    std::optional<std::vector<PlannedPhoto>> take_ahead();

  private:
    void work(const std::stop_token& stop);

    const PlanScene* scene_;
    bool busy_ = false;
    std::mutex mutex_;
    std::condition_variable_any changed_;
    std::optional<PlanJob> job_;  ///< to do
    PlanJob done_;
    std::optional<Plans> made_;                       ///< to take
    std::optional<std::vector<PlannedPhoto>> ahead_;  ///< to take
    std::exception_ptr failure_;
    std::jthread thread_;
};

}  // namespace vantage
