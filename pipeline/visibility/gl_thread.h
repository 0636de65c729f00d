#pragma once
#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <mutex>
#include <thread>

#include "gl/context.h"

namespace vantage {

/// The one thread that owns a headless OpenGL context. Work is run in the order it was submitted; exceptions
/// come back through the futures. Starting takes a while and does not hold up the constructor.
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
    /// Waits for the start. Throws Error(graphics) when there is no OpenGL: then all work is refused.
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
