#include "player/options/window_options.h"

#include "base/cli/command.h"
#include "player/options/frame_goal.h"

namespace vantage {

void add_window_options(const Command& c, WindowOptions& o) {
    const std::string group = "Window";
    c.integer("--frames", o.frames, 0, 1 << 30, "close after this many frames; 0: never").group(group);
    add_fps_option(c, o.fps, group);
    c.flag("--no-saved-settings", o.fresh, "start with default settings, and do not save changes")
        .group(group);
    c.text("--language", o.language,
           "language of the window and of stories, such as de or fr (default: the system's, or else the "
           "story's)")
        .type("CODE")
        .group(group);
    c.real("--text-scale", o.text_scale, 0.7, 4,
           "text size, relative to 14 pixels (default: from the display)")
        .group(group);
    c.file("--controls", o.controls,
           "write the position of each control to this file, for scripts: name, x, y, width, height")
        .group(group);
    c.file("--screenshot", o.screenshot, "save the last frame, with all panels, before closing, as PNG")
        .group(group);
}

void add_kiosk_options(const Command& c, WindowOptions& o) {
    c.real("--idle-timeout", o.home_after, 1, 86400,
           "seconds until an idle kiosk returns to the first view (default: from the story, or 60)");
    c.file("--attract", o.tour,
           "recorded path to play in a loop until someone touches the screen (default: from the story)");
}

}  // namespace vantage
