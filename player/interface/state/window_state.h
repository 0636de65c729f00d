#pragma once
#include <string>
#include <vector>

#include "player/interface/state/user_command.h"
#include "player/interface/state/user_input.h"
#include "player/view/view.h"

namespace vantage {

/// The parts of the interface that are shown.
struct Panels {
    bool bar = true, photos = true, frusta = false, radar = false, help = false;
    bool expert = false;  ///< the menu, and the sidebar with the sections that follow
    bool picture = true, photo_list = false, cut = false, orthophoto = false, blending = true, status = false,
         objects = false;
    bool fields = true;  ///< if the package has scalar fields of its own; see fields_open()
    bool points = true, image_sets = true;    ///< only if the package has any
    bool measure = false;                     ///< and clicks measure
    bool story = true, story_editor = false;  ///< notes and tours, if there are any; editing them
};

/// What belongs to the window, whichever package it shows.
struct WindowState {
    Panels panels;
    bool full_screen = false;
    bool keyboard = true;  ///< and a pointer in the picture; else nothing can be typed or clicked there
    bool kiosk = false;    ///< for the public: nothing can be opened, written, set or quit
    float text_scale = 1;
    /// Of the window and of stories, such as "de-AT"; empty: English, and the story's own.
    std::string language;
    Area free;  ///< the part that no panel covers, to which the picture is fitted

    UserInput input;                  ///< not taken yet
    std::vector<KeyPress> measuring;  ///< keys for the mode of measuring
    bool menu_open = false;           ///< or a list, in the last frame
    bool navigates = false;           ///< a control was marked for keys in the last frame
    bool touched = false;             ///< something happened in the window since the last frame
    UserCommands commands;
};

}  // namespace vantage
