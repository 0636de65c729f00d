#pragma once
#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace vantage {

/// Closes the window.
struct Quit {};
/// Replaces the shown scene with a package or a scene file.
struct OpenFile {
    std::string file;
};
/// Asks the user for a file to open.
struct ChooseFile {};
/// Asks the user whether to open or add a package that was dropped on the window.
struct PlaceDropped {
    std::string file;
};
/// Adds a package to the scene.
struct AddObject {
    std::string file;
};
/// Saves the picture, without the interface.
struct SaveScreenshot {};
/// Saves a table. `name`: a text in the context "written", also the end of the file's name.
struct SaveTable {
    const char* name;
    std::string csv;
};
/// Saves the objects and their placements as a scene file.
struct SaveScene {};
/// Saves the section's outlines as a drawing.
struct SaveCut {};
struct SaveOrthophoto {};
/// Shows the folder of a file in the desktop's file manager.
struct ShowFolder {
    std::string file;
};
/// Copies the view to the clipboard as a command line.
struct CopyView {};
/// Flies to the view given as text.
struct PasteView {
    std::string text;
};
/// Undoes the last change.
struct Undo {};
/// Repeats the change that was undone last.
struct Redo {};
/// Closes open menus and lists.
struct CloseMenus {};

/// A command from a key, a menu, a panel or a dropped file.
using UserCommand =
    std::variant<Quit, OpenFile, ChooseFile, PlaceDropped, AddObject, SaveScreenshot, SaveTable, SaveScene,
                 SaveCut, SaveOrthophoto, ShowFolder, CopyView, PasteView, Undo, Redo, CloseMenus>;
/// Pending commands, in the order in which they were given. Each kind is handled in one place.
using UserCommands = std::vector<UserCommand>;

template <class... Kinds>
bool is_one_of(const UserCommand& command) {
    return (std::holds_alternative<Kinds>(command) || ...);
}

template <class Kind>
bool holds(const UserCommands& commands) {
    return std::ranges::any_of(commands, is_one_of<Kind>);
}

/// Removes and returns the first command of these kinds, if there is one.
template <class... Kinds>
std::optional<UserCommand> take_one_of(UserCommands& commands) {
    const auto at = std::ranges::find_if(commands, is_one_of<Kinds...>);
    if (at == commands.end()) return {};
    UserCommand taken = std::move(*at);
    commands.erase(at);
    return taken;
}

/// Removes and returns the first command of one kind, if there is one.
template <class Kind>
std::optional<Kind> take(UserCommands& commands) {
    std::optional<UserCommand> taken = take_one_of<Kind>(commands);
    return taken ? std::optional(std::get<Kind>(std::move(*taken))) : std::nullopt;
}

/// Removes all commands of one kind, which are executed as one. Returns whether there were any.
template <class Kind>
bool take_all(UserCommands& commands) {
    return std::erase_if(commands, is_one_of<Kind>) > 0;
}

}  // namespace vantage
