#pragma once
#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

#include "values/descriptor.h"

namespace vantage {

/// This program once more, beside the window: for work that takes long. It goes on if the window closes.
class OwnProgram {
  public:
    /// Starts it with these arguments. Throws Error(input) if that fails.
    explicit OwnProgram(std::vector<std::string> arguments);
    ~OwnProgram() = default;
    OwnProgram(const OwnProgram&) = delete;
    OwnProgram& operator=(const OwnProgram&) = delete;

    struct Ended {
        bool well;         ///< with exit code 0
        std::string says;  ///< the first line of its errors, or empty
    };
    /// Set once it has ended; asks without waiting.
    std::optional<Ended> ended();

  private:
    std::string first_error() const;
    Descriptor errors_;
    pid_t process_ = -1;
};

}  // namespace vantage
