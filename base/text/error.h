#pragma once
#include <stdexcept>
#include <string>

namespace vantage {

/// Exit codes of both programs. The codes are documented for users, so the meaning of a number never changes.
enum class Exit : int {
    ok = 0,
    usage = 2,        ///< the command line or a configuration file is wrong
    input = 3,        ///< an input is missing, unreadable or inconsistent with the others
    damaged = 4,      ///< a package is truncated, corrupt or not a package
    stale = 5,        ///< a package is valid, but its inputs have changed
    storage = 6,      ///< the disk is full, or a file cannot be read or written
    graphics = 7,     ///< OpenGL 4.5 is not available or failed
    interrupted = 8,  ///< stopped by a signal
    incomplete = 9,   ///< a package is valid, but some photos were skipped
    different = 10,   ///< packages or pictures differ
    internal = 11,    ///< a bug
    memory = 12,      ///< out of memory
    misplaced = 13    ///< the mesh is not in view: its scale, frame or position differs from the cameras'
};

/// An error to report to the user. An Error has an exit code and a one-line message that states the file, the
/// item, the expected value and the actual value.
class Error : public std::runtime_error {
  public:
    Error(Exit code, const std::string& message) : std::runtime_error(message), code_(code) {}
    Exit code() const { return code_; }

  private:
    Exit code_;
};

}  // namespace vantage
