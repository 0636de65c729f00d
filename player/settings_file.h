#pragma once
#include <filesystem>

#include "player/session.h"
#include "player/shots.h"

namespace vantage {

/// Where the player remembers: $XDG_CONFIG_HOME/vantage or ~/.config/vantage; empty where there is no home.
std::filesystem::path settings_folder();

/// What the player remembers from window to window. A missing or unreadable file leaves everything as it is.
struct Remembered {
    FrameSize window{1280, 720};
    RenderSettings settings;
    Panels panels;
};
Remembered read_settings(const std::filesystem::path& folder, Remembered otherwise);
/// Never throws: a window that cannot remember is still a window.
void write_settings(const std::filesystem::path& folder, const Remembered& remembered);

}  // namespace vantage
