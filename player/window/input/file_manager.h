#pragma once
#include <optional>

#include "player/interface/state/message.h"
#include "player/interface/state/user_command.h"
#include "player/window/child_program.h"

namespace vantage {

/// The desktop's file manager, started by xdg-open.
class FileManager {
  public:
    /// Shows the folders that are requested, and reports failures.
    void attend(UserCommands& commands, Message& message, double now);
    bool starts() const { return program_.has_value(); }

  private:
    std::optional<ChildProgram> program_;
};

}  // namespace vantage
