#include "pipeline/commands/stop_signals.h"

#include <unistd.h>

#include <csignal>
#include <cstring>

#include "scene/error.h"

namespace vantage {
namespace {

std::atomic<bool> stop{false};
static_assert(std::atomic<bool>::is_always_lock_free);

/// Async-signal-safe.
void on_signal(int) {
    if (stop.exchange(true)) ::_exit(int(Exit::interrupted));
    static constexpr char text[] =
        "\nstopping after the photos in flight; a second signal stops immediately\n";
    if (::write(STDERR_FILENO, text, sizeof text - 1) < 0) {
        // stderr is closed.
    }
}

}  // namespace

const std::atomic<bool>& stop_on_signals() {
    struct sigaction action {};
    action.sa_handler = on_signal;
    action.sa_flags = SA_RESTART;
    ::sigaction(SIGINT, &action, nullptr);
    ::sigaction(SIGTERM, &action, nullptr);
    return stop;
}

}  // namespace vantage
