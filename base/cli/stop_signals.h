#pragma once
#include <atomic>

namespace vantage {

/// How a stop signal affects the work in flight.
enum class InFlight {
    /// A notice is printed and the work is finished. A second signal exits at once with Exit::interrupted,
    /// which is
    /// safe because results are saved as they are made.
    finished,
    abandoned  ///< system calls are interrupted, so that unfinished results can be removed
};

/// Installs handlers for SIGINT, SIGTERM and, unless it is ignored (as under nohup), SIGHUP. The handlers set
/// the returned flag.
const std::atomic<bool>& stop_on_signals(InFlight work);

}  // namespace vantage
