#include "player/options/window_options.h"

#include "values/lower_extension.h"

namespace vantage {

void add_window_options(CLI::App& app, WindowOptions& o) {
    const std::string group = "Window";
    app.add_option("--frames", o.frames, "close after this many frames")
        ->check(CLI::Range(0, 1 << 30))
        ->group(group);
    app.add_flag("--fresh", o.fresh, "start with default settings, and do not remember any")->group(group);
    app.add_option("--controls", o.controls,
                   "write the position of each control to this file, for scripts: name, x, y, width, height")
        ->group(group);
    app.add_option("--screenshot", o.screenshot, "save the last frame before closing, as PNG")
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
