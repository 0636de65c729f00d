#pragma once
#include <atomic>

namespace vantage {

/// From now on SIGINT and SIGTERM set the flag, so that the work in hand can be finished; a second one ends
/// the program at once, with the exit code of an interruption. That is safe: what is done is kept as it is
/// done.
const std::atomic<bool>& stop_on_signals();

}  // namespace vantage
