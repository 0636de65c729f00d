#pragma once
#include <atomic>

namespace vantage {

/// What a signal to stop does to the work in flight.
enum class InFlight {
    /// It is finished, and a notice says so. A second signal exits at once with Exit::interrupted, which is
    /// safe: results are saved as they are made.
    finished,
    abandoned  ///< System calls are interrupted, so that what is half done can be removed.
};

/// Installs handlers for SIGINT, SIGTERM and, unless it is ignored as under nohup, SIGHUP that set the
/// returned flag.
const std::atomic<bool>& stop_on_signals(InFlight work);

}  // namespace vantage
