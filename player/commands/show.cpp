#include <cstdio>
#include <string>

#include "cli/exit_codes.h"
#include "player/commands/commands.h"
#include "player/commands/offscreen.h"
#include "player/commands/parse.h"
#include "player/window/run_window.h"
#include "scene/package_reader.h"

namespace vantage {
namespace {

void list_photos(const PackageReader& package) {
    for (const package::PhotoRecord& p : package.photos())
        std::printf("%s  %ux%u  sees %.1f %% of the vertices%s\n", p.name, p.width, p.height,
                    100 * p.visible_vertices, p.flags & package::photo_held_out ? "  held out" : "");
}

/// One line per verb.
std::string verbs_text() {
    std::string out;
    for (const Verb& verb : verbs) {
        std::string name = verb.name;
        name.resize(12, ' ');
        out += "  " + name + verb.description + "\n";
    }
    return out;
}

}  // namespace

void add_show_options(CLI::App& app, ShowOptions& o) {
    add_package_options(app, o.package);
    app.add_flag("--list", o.list, "list the photos and exit");
    add_output_options(app, o.output);
    add_memory_options(app, o.memory);
    add_blending_options(app, o.blending);
    add_layer_options(app, o.layer);
    add_light_options(app, o.light);
    add_point_options(app, o.points);
    add_picture_options(app, o.pictures);
    add_window_options(app, o.window);
    app.footer(
        "Examples:\n"
        "  vantage-player chapel.vantage\n"
        "  vantage-player chapel.vantage --offscreen --photo 0003 -o 0003.png\n"
        "  vantage-player chapel.vantage --offscreen --photo all --scale 0.5 --blend best -o pictures\n"
        "  vantage-player chapel.vantage --offscreen --view 4,-9,2,0,0,1,40 --size 1920x1080 -o view.png\n"
        "  vantage-player chapel.vantage --offscreen --photo 0003 --layer deviation --isolines 10 -o "
        "map.png\n"
        "  vantage-player chapel.vantage --offscreen --photo 0003 --light raking --lamp 200,10 -o "
        "relief.png\n"
        "Verbs (vantage-player VERB --help):\n" +
        verbs_text() + exit_codes_text());
}

int show_command(int argc, char** argv) {
    CLI::App app{"vantage-player shows a prepared package: a scanned object through its own photos."};
    app.set_version_flag("--version", "vantage-player " VANTAGE_VERSION);
    ShowOptions options;
    add_show_options(app, options);
    if (const auto code = parse(app, argc, argv)) return *code;
    const PackageReader package(options.package.file);
    package.meta();  // not needed for showing, but reports damage
    if (options.list) return list_photos(package), 0;
    return options.pictures.offscreen ? run_offscreen(package, options) : run_window(package, options);
}

}  // namespace vantage
