#include "pipeline/gl_thread.h"

#include "scene/error.h"

namespace vantage {

GlThread::GlThread() {
    std::promise<gl::Device> started;
    auto device = started.get_future();
    thread_ = std::jthread([this, p = std::move(started)]() mutable { run(std::move(p)); });
    try {
        device_ = device.get();
    } catch (const std::exception& e) {
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
        queue_.push_back(std::move(work));
    }
    wake_.notify_one();
}

void GlThread::run(std::promise<gl::Device> started) {
    try {
        const gl::HeadlessContext context;
        started.set_value(gl::current_device());
        for (;;) {
            std::unique_lock lock(mutex_);
            wake_.wait(lock, [&] { return closed_ || !queue_.empty(); });
            if (queue_.empty()) return;
            const auto work = std::move(queue_.front());
            queue_.pop_front();
            lock.unlock();
            work();
        }
    } catch (...) {
        started.set_exception(std::current_exception());
    }
}

}  // namespace vantage
