#pragma once
#include <filesystem>
#include <functional>

namespace vantage {

/// Runs the player in a child process for a kiosk, and restarts it after it has ended or has been
/// unresponsive for a minute. `run` gets a file descriptor to which it writes a byte at least every 10
/// seconds, and returns an exit code. Ends with SIGTERM or SIGINT, and with the player's exit code if the
/// first picture was never shown because of the user's input: usage, input, damaged. Logs events to `log`, or
/// to stderr if that is empty. Must be called before threads are started.
int supervise(const std::function<int(int heartbeat_fd)>& run, const std::filesystem::path& log);

/// $XDG_STATE_HOME/vantage/kiosk.log or ~/.local/state/vantage/kiosk.log; empty without a home folder.
std::filesystem::path kiosk_log();

}  // namespace vantage
