#pragma once
#include <stdexcept>
#include <string>

namespace vantage {

/// Exit codes of both programs; README lists them. One number, one meaning, for ever.
enum class Exit : int {
    ok = 0,
    usage = 2,        ///< the command line or a configuration file is wrong
    input = 3,        ///< an input is missing, unreadable or does not fit the others
    damaged = 4,      ///< a package is cut short, changed or not a package
    stale = 5,        ///< a package is sound but its inputs have changed
    storage = 6,      ///< the disk is full or cannot be written
    graphics = 7,     ///< no usable OpenGL 4.5, or it failed
    interrupted = 8,  ///< stopped by a signal
    incomplete = 9,   ///< a package is sound, but photos had to be left out
    different = 10    ///< packages or pictures differ
};

/// The one exception of Vantage: a message for one line, naming file, item, expectation and finding,
/// and the exit code it ends the program with.
class Error : public std::runtime_error {
  public:
    Error(Exit code, const std::string& message) : std::runtime_error(message), code_(code) {}
    Exit code() const { return code_; }

  private:
    Exit code_;
};

}  // namespace vantage
