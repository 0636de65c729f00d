#pragma once
#include <atomic>

namespace vantage {

/// Effect of a stop signal on the work in flight.
enum class InFlight {
    /// The work is finished, after a notice. A second signal exits at once with Exit::interrupted, which is
    /// safe because results are saved as they are made.
    finished,
    abandoned  ///< System calls are interrupted, so that unfinished results can be removed.
};

/// Installs handlers that set the returned flag, for SIGINT, SIGTERM and, unless it is ignored (as under
/// nohup), SIGHUP.
const std::atomic<bool>& stop_on_signals(InFlight work);

}  // namespace vantage
