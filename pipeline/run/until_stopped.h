#pragma once
#include <atomic>
#include <functional>
#include <string>

#include "base/values/progress.h"

namespace vantage {

/// Called during long operations, by one thread at a time. An exception from it aborts the operation.
using OnProgress = std::function<void(const Progress&)>;

/// A callback that calls `report`, if not empty, until `*stop` is set, and from then on throws
/// Error(interrupted, `message`). A null `stop` is never set.
OnProgress until_stopped(const std::atomic<bool>* stop, std::string message, OnProgress report);

}  // namespace vantage
