#pragma once
#include <atomic>
#include <cstddef>
#include <functional>
#include <string>

namespace vantage {

/// What is going on, for a progress line.
struct Progress {
    const char* stage;
    std::string photo;
    std::size_t done, total;
};

/// Called now and then by long work, from one thread at a time; what it throws ends the work.
using OnProgress = std::function<void(const Progress&)>;

/// Reports, and throws Error(interrupted, `kept`) once the flag is set; null: never.
OnProgress until_stopped(const std::atomic<bool>* stop, std::string kept, OnProgress report);

}  // namespace vantage
