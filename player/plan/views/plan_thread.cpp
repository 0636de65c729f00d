#include "player/plan/views/plan_thread.h"

#include <algorithm>
#include <iterator>
#include <new>
#include <utility>

namespace vantage {
namespace {

/// The previous plans' photos, with their tiles for the next expected view. Returns no photos if memory is
/// insufficient.
std::vector<PlannedPhoto> photos_ahead(const PlanScene& scene, const PlanJob& job) try {
    std::vector<PlannedPhoto> out;
    for (const PlanJob::One& one : job.plans) {
        if (one.shares || !one.before) continue;
        const std::vector<std::uint32_t> photos = numbers_of(one.before->plan.photos);
        Plan plan = make_plan(scene, *job.next, settings_for_samples(one.order), photos);
        std::ranges::move(plan.photos, std::back_inserter(out));
        std::ranges::move(plan.behind, std::back_inserter(out));
    }
    return out;
} catch (const std::bad_alloc&) {
    return {};
}

}  // namespace

PlanThread::Plans plans_of(const PlanScene& scene, const PlanJob& job) {
    PlanThread::Plans out;
    for (const PlanJob::One& one : job.plans) {
        const PhotoChoice* const shared = one.shares ? &out.at(*one.shares)->plan.choice : nullptr;
        out.push_back(
            std::make_shared<const PlannedView>(plan_view(scene, one.order, one.before.get(), shared)));
    }
    return out;
}

PlanThread::PlanThread(const PlanScene& scene)
    : scene_(&scene), thread_([this](const std::stop_token& stop) { work(stop); }) {}

PlanJob PlanThread::begin(PlanJob job) {
    busy_ = true;
    const std::scoped_lock lock(mutex_);
    job_ = std::move(job);
    changed_.notify_all();
    return std::exchange(done_, {});
}

std::optional<PlanThread::Plans> PlanThread::take(bool wait) {
    if (!busy_) return {};
    std::unique_lock lock(mutex_);
    if (wait) changed_.wait(lock, [&] { return made_ || failure_; });
    if (!made_ && !failure_) return {};
    busy_ = false;
    if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
    return std::exchange(made_, std::nullopt);
}

std::optional<std::vector<PlannedPhoto>> PlanThread::take_ahead() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(ahead_, std::nullopt);
}

void PlanThread::work(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (changed_.wait(lock, stop, [&] { return job_.has_value(); })) {
        PlanJob job = std::move(*std::exchange(job_, std::nullopt));
        lock.unlock();
        std::optional<Plans> made;
        std::exception_ptr failure;
        try {
            made = job.only_next ? Plans() : plans_of(*scene_, job);
        } catch (...) {
            failure = std::current_exception();
        }
        lock.lock();
        made_ = std::move(made), failure_ = failure;
        changed_.notify_all();
        if (job.next && !failure) {
            lock.unlock();
            std::vector<PlannedPhoto> ahead = photos_ahead(*scene_, job);
            lock.lock();
            ahead_ = std::move(ahead);
        }
        done_ = std::move(job);
    }
}

}  // namespace vantage
