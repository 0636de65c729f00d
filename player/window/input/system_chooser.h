#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "player/interface/state/message.h"
#include "player/interface/state/user_command.h"
#include "player/window/child_program.h"

namespace vantage {

/// The desktop's own dialog to choose a package, with zenity or kdialog.
class SystemChooser {
  public:
    /// Handles requests to choose a file, if there is such a dialog, in place of the window's own; and opens
    /// the chosen file. `folder`: initial folder.
    void attend(UserCommands& commands, Message& message, const std::filesystem::path& folder, double now);
    bool asks() const { return program_.has_value(); }

  private:
    void ask(const std::string& program, const std::filesystem::path& folder);
    std::optional<ChildProgram> program_;
};

}  // namespace vantage
