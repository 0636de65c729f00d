#include "player/options/window_options.h"

#include "cli/real_range.h"
#include "player/options/frame_goal.h"
#include "values/lower_extension.h"

namespace vantage {

void add_window_options(CLI::App& app, WindowOptions& o) {
    const std::string group = "Window";
    app.add_option("--frames", o.frames, "close after this many frames")
        ->check(CLI::Range(0, 1 << 30))
        ->group(group);
    add_fps_option(app, o.fps, group);
    app.add_flag("--fresh", o.fresh, "start with default settings, and do not remember any")->group(group);
    app.add_flag("--kiosk", o.kiosk,
                 "for the public: full screen, without quitting, opening or settings; restarted if it fails "
                 "(SIGTERM ends it; log: ~/.local/state/vantage/kiosk.log)")
        ->group(group);
    app.add_option("--home-after", o.home_after,
                   "a kiosk returns to the first view after so many seconds (default: as the story says, or "
                   "60)")
        ->check(real_range(1, 86400))
        ->group(group);
    app.add_option(
           "--attract", o.tour,
           "a recorded path that a kiosk flies along until somebody touches it (default: as the story "
           "says)")
        ->type_name("FILE")
        ->group(group);
    app.add_option("--language", o.language,
                   "language of the window and of stories, such as de or fr (default: the system's)")
        ->type_name("CODE")
        ->group(group);
    app.add_option("--text-scale", o.text_scale,
                   "size of text, relative to 14 pixels (default: by the display)")
        ->check(real_range(0.7, 4))
        ->group(group);
    app.add_option("--controls", o.controls,
                   "write the position of each control to this file, for scripts: name, x, y, width, height")
        ->type_name("FILE")
        ->group(group);
    app.add_option("--screenshot", o.screenshot,
                   "save the last frame, with all panels, before closing, as PNG")
        ->type_name("FILE")
        ->check([](const std::string& file) {
            return lower_extension(file) == ".png" ? "" : file + ": expected a name that ends with .png";
        })
        ->group(group);
    app.add_flag_callback(
           "--debug-gl", [&o] { o.debug_gl = gl::Debug::on; },
           "report errors through an OpenGL debug context; slower")
        ->group(group);
}

}  // namespace vantage
