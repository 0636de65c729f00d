#include "base/cli/stop_signals.h"

#include <unistd.h>

#include <csignal>

#include "base/text/error.h"

namespace vantage {
namespace {

std::atomic<bool> stop_signaled{false};
static_assert(std::atomic<bool>::is_always_lock_free);

/// Async-signal-safe.
void finish_work(int) {
    if (stop_signaled.exchange(true)) ::_exit(int(Exit::interrupted));
    static constexpr char text[] =
        "\nstopping after the photos in flight; a second signal stops immediately\n";
    if (::write(STDERR_FILENO, text, sizeof text - 1) < 0) {
        // stderr is closed.
    }
}

void abandon_work(int) { stop_signaled = true; }

}  // namespace

const std::atomic<bool>& stop_on_signals(InFlight work) {
    struct sigaction action {};
    action.sa_handler = work == InFlight::finished ? finish_work : abandon_work;
    action.sa_flags = work == InFlight::finished ? SA_RESTART : 0;
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction before {};
        ::sigaction(signal, nullptr, &before);
        if (signal != SIGHUP || before.sa_handler != SIG_IGN) ::sigaction(signal, &action, nullptr);
    }
    return stop_signaled;
}

}  // namespace vantage
