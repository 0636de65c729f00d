#include <cstdio>

#include "player/offscreen.h"
#include "player/options.h"
#include "player/window.h"
#include "scene/error.h"

namespace {

void list_photos(const vantage::PackageReader& package) {
    for (const vantage::package::PhotoRecord& p : package.photos())
        std::printf("%s  %ux%u  sees %.1f %% of the vertices%s\n", p.name, p.width, p.height,
                    100 * p.visible_vertices, p.flags & vantage::package::photo_held_out ? "  held out" : "");
}

}  // namespace

int main(int argc, char** argv) {
    using namespace vantage;
    CLI::App app{"vantage-player shows a prepared package: a scanned object through its own photos."};
    app.set_version_flag("--version", "vantage-player " VANTAGE_VERSION);
    Options options;
    add_options(app, options);
    try {
        app.parse(argc, argv);
        const PackageReader package(options.package);
        package.meta();  // not needed to show it, but damage is said
        if (options.list) return list_photos(package), 0;
        return options.offscreen ? run_offscreen(package, options) : run_window(package, options);
    } catch (const CLI::ParseError& e) {
        return app.exit(e) == 0 ? 0 : int(Exit::usage);
    } catch (const Error& e) {
        std::fprintf(stderr, "vantage-player: %s\n", e.what());
        return int(e.code());
    } catch (const std::exception& e) {
        std::fprintf(stderr, "vantage-player: %s\n", e.what());
        return int(Exit::graphics);
    }
}
