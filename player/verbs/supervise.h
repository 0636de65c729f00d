#pragma once
#include <filesystem>
#include <functional>

namespace vantage {

/// Runs the player in a process of its own, and again when that ends or has given no sign of life for a
/// minute: for a kiosk. `run` gets a file descriptor to which it writes a byte at least every 10 seconds, and
/// returns an exit code. Ends with SIGTERM or SIGINT, and with the player's exit code if the first picture
/// was never shown because of what the user gave: usage, input, damaged. Appends what happens to `log`, or to
/// stderr if that is empty. Must be called before there are threads.
int supervise(const std::function<int(int heartbeat_fd)>& run, const std::filesystem::path& log);

/// $XDG_STATE_HOME/vantage/kiosk.log or ~/.local/state/vantage/kiosk.log; empty if there is no home.
std::filesystem::path kiosk_log();

}  // namespace vantage
