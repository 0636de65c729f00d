#pragma once
#include <string>
#include <vector>

#include "player/interface/state/user_command.h"
#include "player/interface/state/user_input.h"
#include "player/view/view.h"

namespace vantage {

/// The visible parts of the interface.
struct Panels {
    bool bar = true, photos = true, frusta = false, radar = false, help = false;
    bool expert = false;  ///< the menu bar and the sidebar
    /// The sidebar's groups of which all controls are shown.
    bool picture = false, photo_list = false, blending = false, fields = false, points = false,
         image_sets = false, objects = false, surveying = false, movement = false, status = false;
    bool measure = false;                     ///< measuring mode
    bool story = true, story_editor = false;  ///< notes and tours, if there are any; the editor
    bool operator==(const Panels&) const = default;
};

/// State of the window that is independent of the package.
struct WindowState {
    Panels panels;
    bool full_screen = false;
    bool keyboard = true;  ///< keyboard and mouse; otherwise the picture accepts no input
    bool kiosk = false;    ///< public mode: no opening, saving, settings or quitting
    float text_scale = 1;
    /// Language of the window and of stories, such as "de-AT"; empty: the story's.
    std::string language;
    std::vector<std::string> story_languages;  ///< languages of the shown scene's story
    std::string web;                           ///< the story's page on the web; may be empty
    Area free;                                 ///< the area without panels
    Area picture;                              ///< the area to which the picture is fitted, see PictureArea

    UserInput input;                  ///< unhandled input
    std::vector<KeyPress> measuring;  ///< keys that measuring mode handles
    bool menu_open = false;           ///< a menu or list was open in the last frame
    bool navigates = false;           ///< a control had the keyboard focus in the last frame
    bool places_note = false;         ///< the next click on the model places a note
    bool hides_pieces = false;        ///< clicks hide pieces of the scene
    bool touched = false;             ///< any input since the last frame
    bool tour = false;                ///< a tour hides the interface
    UserCommands commands;
};

}  // namespace vantage
