#include "player/commands/unused_options.h"

namespace vantage {

void add_unused_options(CLI::App& app, UnusedOptions& o) {
    const std::size_t first = app.get_options().size();
    app.add_flag("--list", o.list);
    add_picture_options(app, o.pictures);
    add_stereo_options(app, o.stereo);
    add_window_options(app, o.window);
    const std::vector<CLI::Option*> all = app.get_options([](CLI::Option*) { return true; });
    for (std::size_t i = first; i < all.size(); ++i) all[i]->group("");
}

void hide(CLI::App& app, std::initializer_list<const char*> names) {
    for (const char* name : names) app.get_option(name)->group("");
}

}  // namespace vantage
