#pragma once
#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <mutex>
#include <thread>

#include "base/gl/context.h"

namespace vantage {

/// A thread that owns a headless OpenGL context. Runs submitted tasks in order; exceptions propagate through
/// the futures. The context is created asynchronously, so the constructor does not block.
class GlThread {
  public:
    GlThread();
    ~GlThread();

    template <class F>
    auto submit(F work) -> std::future<decltype(work())> {
        auto task = std::make_shared<std::packaged_task<decltype(work())()>>(std::move(work));
        auto result = task->get_future();
        push([task] { (*task)(); });
        return result;
    }
    /// Blocks until the context exists. Throws Error(graphics) if OpenGL is unavailable; submitted tasks then
    /// fail with a broken promise.
    gl::Device device() const;

  private:
    void push(std::function<void()> work);
    void run(std::promise<gl::Device> started);

    std::mutex mutex_;
    std::condition_variable wake_;
    std::deque<std::function<void()>> queue_;
    bool closed_ = false;
    std::shared_future<gl::Device> device_;
    std::jthread thread_;
};

}  // namespace vantage
