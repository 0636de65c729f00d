#pragma once
#include <CLI/CLI.hpp>
#include <initializer_list>

#include "player/options/picture_options.h"
#include "player/options/stereo_options.h"
#include "player/options/window_options.h"

namespace vantage {

/// Options of `vantage-player FILE` that other verbs accept but ignore, so that one set of options works for
/// all verbs.
struct UnusedOptions {
    PictureOptions pictures;
    StereoSettings stereo;
    WindowOptions window;
    bool list = false;
};
/// Adds them without help texts.
void add_unused_options(CLI::App& app, UnusedOptions& options);

/// Removes options from the help text.
void hide(CLI::App& app, std::initializer_list<const char*> names);

}  // namespace vantage
