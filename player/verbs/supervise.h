#pragma once
#include <filesystem>
#include <functional>

namespace vantage {

/// Runs the player in a child process for a kiosk, and restarts it after it has ended or has been
/// unresponsive for a minute. `run` receives a file descriptor, must write a byte to it at least every 10
/// seconds, and returns an exit code. Ends on SIGTERM or SIGINT. Also ends, with the player's exit code, if a
/// fault in the user's input (usage, input, damaged) prevented even the first picture. Logs events to `log`,
/// or to stderr if `log` is empty. Must be called before any threads are started.
int supervise(const std::function<int(int heartbeat_fd)>& run, const std::filesystem::path& log);

/// $XDG_STATE_HOME/vantage/kiosk.log or ~/.local/state/vantage/kiosk.log; empty without a home folder.
std::filesystem::path kiosk_log();

}  // namespace vantage
