#pragma once
#include <atomic>
#include <functional>
#include <string>

#include "base/values/progress.h"

namespace vantage {

/// Called during long operations, by one thread at a time. If it throws, the operation is aborted.
using OnProgress = std::function<void(const Progress&)>;

/// A callback that calls `report`, if that is not empty, until `*stop` is set; from then on it throws
/// Error(interrupted, `message`). If `stop` is null, it never throws.
OnProgress until_stopped(const std::atomic<bool>* stop, std::string message, OnProgress report);

}  // namespace vantage
