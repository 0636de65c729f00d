#pragma once
#include <atomic>

namespace vantage {

/// Installs handlers for SIGINT and SIGTERM that set the returned flag, so that work in flight can be
/// finished. A second signal exits immediately with Exit::interrupted, which is safe: results are saved as
/// they are made.
const std::atomic<bool>& stop_on_signals();

}  // namespace vantage
