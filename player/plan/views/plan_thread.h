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
        std::optional<std::size_t> shares{};        ///< the plan of this job whose photos this plan uses
    };
    std::vector<One> plans;
    /// The next expected view: its tiles are prefetched.
    std::optional<View> next{};
    bool only_next = false;  ///< the plans of the views have been made already
};

/// The plans of a job, in the order in which they are listed. This is a pure function.
std::vector<std::shared_ptr<const PlannedView>> plans_of(const PlanScene& scene, const PlanJob& job);

/// Makes plans on a separate thread, so that frames do not wait for them. The scene must outlive the thread.
class PlanThread {
  public:
    using Plans = std::vector<std::shared_ptr<const PlannedView>>;

    explicit PlanThread(const PlanScene& scene);
    /// Whether there is a job whose plans have not been taken yet.
    bool busy() const { return busy_; }
    /// Starts a job. Must not be called while busy. Returns a finished or empty job, whose memory can be
    /// reused.
    PlanJob begin(PlanJob job);
    /// Returns the finished plans, once for each job. `wait`: blocks until they exist. Rethrows errors of the
    /// thread.
    std::optional<Plans> take(bool wait);
    /// Returns the photos to prefetch, once for each job that requests them.
    std::optional<std::vector<PlannedPhoto>> take_ahead();

  private:
    void work(const std::stop_token& stop);

    const PlanScene* scene_;
    bool busy_ = false;
    std::mutex mutex_;
    std::condition_variable_any changed_;
    std::optional<PlanJob> job_;  ///< job in progress
    PlanJob done_;
    std::optional<Plans> made_;                       ///< finished plans
    std::optional<std::vector<PlannedPhoto>> ahead_;  ///< finished prefetch list
    std::exception_ptr failure_;
    std::jthread thread_;
};

}  // namespace vantage
