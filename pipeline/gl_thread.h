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
/// come back through the futures. The constructor throws Error(graphics) when there is no OpenGL.
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
    const gl::Device& device() const { return device_; }

  private:
    void push(std::function<void()> work);
    void run(std::promise<gl::Device> started);

    std::mutex mutex_;
    std::condition_variable wake_;
    std::deque<std::function<void()>> queue_;
    bool closed_ = false;
    gl::Device device_;
    std::jthread thread_;
};

}  // namespace vantage
