#include "player/video/stop_request.h"

#include <csignal>

namespace vantage {
namespace {

std::atomic<bool> stop{false};
static_assert(std::atomic<bool>::is_always_lock_free);

void on_signal(int) { stop = true; }

}  // namespace

const std::atomic<bool>& stop_requested() {
    struct sigaction action {};
    action.sa_handler = on_signal;  // without SA_RESTART
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) ::sigaction(signal, &action, nullptr);
    return stop;
}

}  // namespace vantage
