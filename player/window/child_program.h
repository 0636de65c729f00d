#pragma once
#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

#include "base/files/descriptor.h"

namespace vantage {

/// This program, as ChildProgram starts it.
inline constexpr const char* own_program = "/proc/self/exe";

/// A program that runs beside the window, for what takes long. It goes on if the window closes.
class ChildProgram {
  public:
    /// `program`: a path, or a name to look for in PATH. Throws Error(input) if it cannot be started.
    ChildProgram(const std::string& program, std::vector<std::string> arguments);
    ~ChildProgram() = default;
    ChildProgram(const ChildProgram&) = delete;
    ChildProgram& operator=(const ChildProgram&) = delete;

    struct Ended {
        bool well;           ///< with exit code 0
        std::string prints;  ///< the first line of its output, or empty
        std::string says;    ///< the first line of its errors, or empty
    };
    /// Set once it has ended; asks without waiting.
    std::optional<Ended> ended();

  private:
    Descriptor output_, errors_;
    pid_t process_ = -1;
};

}  // namespace vantage
