#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "player/interface/state/message.h"
#include "player/interface/state/user_command.h"
#include "player/window/child_program.h"

namespace vantage {

/// The desktop's own dialog for choosing a package, shown by zenity or kdialog.
class SystemChooser {
  public:
    /// If there is such a dialog, uses it instead of the window's own dialog for requests to choose a file,
    /// and opens the chosen file. `folder`: the initial folder.
    void attend(UserCommands& commands, Message& message, const std::filesystem::path& folder, double now);
    bool asks() const { return program_.has_value(); }

  private:
    void ask(const std::string& program, const std::filesystem::path& folder);
    std::optional<ChildProgram> program_;
};

}  // namespace vantage
