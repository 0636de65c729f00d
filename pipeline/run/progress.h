#pragma once
#include <atomic>
#include <cstddef>
#include <functional>
#include <string>

namespace vantage {

/// The state of a long operation, for a progress line.
struct Progress {
    const char* stage;
    std::string photo;  ///< empty if the step concerns the whole scene
    std::size_t done, total;
};

/// Called during long operations, by one thread at a time. An exception from it aborts the operation.
using OnProgress = std::function<void(const Progress&)>;

/// A callback that calls `report`, if not empty, until `*stop` is set, and from then on throws
/// Error(interrupted, `message`). A null `stop` is never set.
OnProgress until_stopped(const std::atomic<bool>* stop, std::string message, OnProgress report);

}  // namespace vantage
