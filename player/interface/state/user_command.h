#pragma once
#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace vantage {

/// The window is closed.
struct Quit {};
/// A package or a scene file is shown in place of what is shown.
struct OpenFile {
    std::string file;
};
/// The user is asked for a file to open.
struct ChooseFile {};
/// The user is asked whether a package that was dropped on the window is opened or added.
struct PlaceDropped {
    std::string file;
};
/// A package is shown with the others.
struct AddObject {
    std::string file;
};
/// The picture is saved, without the interface.
struct SaveScreenshot {};
/// Measurements are saved.
struct SaveTable {
    std::string csv;
};
/// The objects and where they stand are saved as a scene file.
struct SaveScene {};
/// The lines of the cut are saved as a drawing.
struct SaveCut {};
struct SaveOrthophoto {};
/// The view is copied to the clipboard as a command line.
struct CopyView {};
/// The camera flies to the view in a text.
struct PasteView {
    std::string text;
};
/// Menus and lists that are open are closed.
struct CloseMenus {};

/// What the user has asked for, by a key, a menu, a panel or a dropped file.
using UserCommand =
    std::variant<Quit, OpenFile, ChooseFile, PlaceDropped, AddObject, SaveScreenshot, SaveTable, SaveScene,
                 SaveCut, SaveOrthophoto, CopyView, PasteView, CloseMenus>;
/// Those that have not been carried out, in the order in which they were given. Each kind is taken in one
/// place.
using UserCommands = std::vector<UserCommand>;

template <class... Kinds>
bool is_one_of(const UserCommand& command) {
    return (std::holds_alternative<Kinds>(command) || ...);
}

template <class Kind>
bool holds(const UserCommands& commands) {
    return std::ranges::any_of(commands, is_one_of<Kind>);
}

/// Takes the first command of these kinds, if there is one.
template <class... Kinds>
std::optional<UserCommand> take_one_of(UserCommands& commands) {
    const auto at = std::ranges::find_if(commands, is_one_of<Kinds...>);
    if (at == commands.end()) return {};
    UserCommand taken = std::move(*at);
    commands.erase(at);
    return taken;
}

/// The same of one kind.
template <class Kind>
std::optional<Kind> take(UserCommands& commands) {
    std::optional<UserCommand> taken = take_one_of<Kind>(commands);
    return taken ? std::optional(std::get<Kind>(std::move(*taken))) : std::nullopt;
}

/// Takes all of one kind, that are carried out as one. Whether there are any.
template <class Kind>
bool take_all(UserCommands& commands) {
    return std::erase_if(commands, is_one_of<Kind>) > 0;
}

}  // namespace vantage
