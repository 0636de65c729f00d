#pragma once
#include <string>

namespace vantage {

class Command;

struct WindowOptions {
    int frames = 0;         ///< 0: until the window is closed
    double fps = -1;        ///< see frame_goal()
    double text_scale = 0;  ///< 0: from the display
    bool kiosk = false;
    double home_after = 0;          ///< seconds; 0: from the story, or 60
    std::string language;           ///< such as "de"; empty: system language
    std::string tour;               ///< path file, for a kiosk
    int heartbeat_fd = -1;          ///< file descriptor for heartbeats; -1: none
    bool fresh = false;             ///< neither read nor write saved settings
    bool errors_in_window = false;  ///< report an error in the package on the start page
    std::string controls;           ///< file for the positions of the controls
    std::string screenshot;         ///< file for the last frame
};
void add_window_options(const Command& command, WindowOptions& options);
void add_kiosk_options(const Command& command, WindowOptions& options);

}  // namespace vantage
