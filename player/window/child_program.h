#pragma once
#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

#include "base/files/descriptor.h"

namespace vantage {

/// The path of this program, for ChildProgram.
inline constexpr const char* own_program = "/proc/self/exe";

/// A child process for long operations. The process continues if the window closes.
class ChildProgram {
  public:
    /// `program`: a path, or a name to search for in PATH. Throws Error(input) if the program cannot be
    /// started.
    ChildProgram(const std::string& program, std::vector<std::string> arguments);
    ~ChildProgram() = default;
    ChildProgram(const ChildProgram&) = delete;
    ChildProgram& operator=(const ChildProgram&) = delete;

    struct Ended {
        bool well;           ///< with exit code 0
        std::string prints;  ///< the first line of its output, or empty
        std::string says;    ///< the first line of its errors, or empty
    };
    /// The result, or empty while the program is running; does not wait.
    std::optional<Ended> ended();

  private:
    Descriptor output_, errors_;
    pid_t process_ = -1;
};

}  // namespace vantage
