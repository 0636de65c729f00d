#include "player/window/input/file_manager.h"

#include <filesystem>

#include "base/text/error.h"
#include "base/text/translation.h"
#include "player/interface/state/failure_text.h"

namespace vantage {

void FileManager::attend(UserCommands& commands, Message& message, double now) {
    while (const auto shown = take<ShowFolder>(commands)) try {
            program_.emplace("xdg-open",
                             std::vector{std::filesystem::path(shown->file).parent_path().string()});
        } catch (const Error& e) {
            say(message, failure_text(tr("The folder cannot be shown."), e), now);
        }
    const auto ended = program_ ? program_->ended() : std::nullopt;
    if (!ended) return;
    program_.reset();
    if (!ended->well) say(message, failure_text(tr("The folder cannot be shown."), ended->says), now);
}

}  // namespace vantage
