#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "player/interface/state/message.h"
#include "player/interface/state/user_command.h"
#include "player/window/child_program.h"

namespace vantage {

/// The desktop's own dialog to choose a package, in a desktop session that has zenity or kdialog.
class SystemChooser {
  public:
    /// Asks in place of the window's own dialog, if a file is to be chosen and there is such a dialog;
    /// and has what was chosen opened. `folder`: where it begins.
    void attend(UserCommands& commands, Message& message, const std::filesystem::path& folder, double now);
    bool asks() const { return program_.has_value(); }

  private:
    void ask(const std::string& program, const std::filesystem::path& folder);
    std::optional<ChildProgram> program_;
};

}  // namespace vantage
