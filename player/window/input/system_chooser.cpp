#include "player/window/input/system_chooser.h"

#include <unistd.h>

#include <cstdlib>
#include <sstream>

#include "base/text/error.h"
#include "base/text/translation.h"
#include "player/interface/state/failure_text.h"

namespace vantage {
namespace {

bool in_path(const std::string& program) {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (::access((folder + "/" + program).c_str(), X_OK) == 0) return true;
    return false;
}

/// "zenity", "kdialog" or empty; prefers the program that belongs to the desktop.
std::string chooser() {
    const char* desktop = std::getenv("XDG_CURRENT_DESKTOP");
    if (!desktop || !*desktop) return "";
    const bool kde = std::string(desktop).find("KDE") != std::string::npos;
    for (const char* program : {kde ? "kdialog" : "zenity", kde ? "zenity" : "kdialog"})
        if (in_path(program)) return program;
    return "";
}

}  // namespace

void SystemChooser::attend(UserCommands& commands, Message& message, const std::filesystem::path& folder,
                           double now) {
    const std::string program = holds<ChooseFile>(commands) ? chooser() : "";
    if (!program.empty()) {
        take_all<ChooseFile>(commands);
        try {
            if (!program_) ask(program, folder);
        } catch (const Error& e) {
            say(message, failure_text(tr("The dialog cannot be opened."), e), now);
        }
    }
    const auto ended = program_ ? program_->ended() : std::nullopt;
    if (!ended) return;
    program_.reset();
    if (ended->well && !ended->prints.empty()) commands.push_back(OpenFile{ended->prints});
}

void SystemChooser::ask(const std::string& program, const std::filesystem::path& folder) {
    const std::string title = tr("Open a package"), what = tr("Vantage packages and scenes"),
                      at = folder.string() + "/";
    using Words = std::vector<std::string>;
    program_.emplace(program,
                     program == "kdialog"
                         ? Words{"--title", title, "--getopenfilename", at, "*.vantage *.toml|" + what}
                         : Words{"--file-selection", "--title=" + title, "--filename=" + at,
                                 "--file-filter=" + what + "|*.vantage *.toml",
                                 std::string("--file-filter=") + tr("All files") + "|*"});
}

}  // namespace vantage
