#include "pipeline/visibility/gl_thread.h"

#include <optional>

#include "base/gl/failure.h"
#include "base/text/error.h"

namespace vantage {

GlThread::GlThread() {
    std::promise<gl::Device> started;
    device_ = started.get_future().share();
    thread_ = std::jthread([this, p = std::move(started)]() mutable { run(std::move(p)); });
}

gl::Device GlThread::device() const {
    try {
        return device_.get();
    } catch (const gl::Failure& e) {
        throw Error(Exit::graphics, e.what());
    }
}

GlThread::~GlThread() {
    {
        const std::scoped_lock lock(mutex_);
        closed_ = true;
    }
    wake_.notify_all();
}

void GlThread::push(std::function<void()> work) {
    {
        const std::scoped_lock lock(mutex_);
        if (closed_) return;  // the future reports a broken promise
        queue_.push_back(std::move(work));
    }
    wake_.notify_one();
}

void GlThread::run(std::promise<gl::Device> started) {
    std::optional<gl::HeadlessContext> context;
    try {
        context.emplace();
        started.set_value(gl::current_device());
    } catch (...) {
        started.set_exception(std::current_exception());
        const std::scoped_lock lock(mutex_);
        closed_ = true;
        queue_.clear();
        return;
    }
    for (;;) {
        std::unique_lock lock(mutex_);
        wake_.wait(lock, [&] { return closed_ || !queue_.empty(); });
        if (queue_.empty()) return;
        const auto work = std::move(queue_.front());
        queue_.pop_front();
        lock.unlock();
        work();
    }
}

}  // namespace vantage
