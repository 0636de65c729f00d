#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "player/interface/state/session.h"
#include "player/view/shots.h"

namespace vantage {

/// The folder of the player's settings: $XDG_CONFIG_HOME/vantage or ~/.config/vantage; empty without a home
/// folder.
std::filesystem::path settings_folder();

/// The player's persistent settings.
struct Remembered {
    FrameSize window{1280, 720};
    double text_scale = 0;  ///< 0: from the display
    RenderSettings settings;
    Panels panels;
    std::string language;                    ///< chosen in the window; empty: system language
    std::string image_set, other_image_set;  ///< names, since numbers differ between packages
    std::vector<std::string> recent;         ///< packages and scene files, most recent first
};
/// The settings in the folder's player.json; missing or invalid settings are taken from `otherwise`.
Remembered read_settings(const std::filesystem::path& folder, Remembered otherwise);
/// Adds an opened package or scene file to the recent files in player.json, and changes nothing else there.
/// Throws Error(storage).
void remember_opened(const std::filesystem::path& folder, const std::string& file);
/// Writes player.json. Throws Error(storage).
void write_settings(const std::filesystem::path& folder, const Remembered& remembered);

}  // namespace vantage
