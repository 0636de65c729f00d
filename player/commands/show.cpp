#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "bands/bands.h"
#include "cli/exit_codes.h"
#include "cli/report_exception.h"
#include "player/commands/commands.h"
#include "player/commands/offscreen.h"
#include "player/commands/parse.h"
#include "player/commands/supervise.h"
#ifdef VANTAGE_OPENXR
#include "player/headset/run_headset.h"
#endif
#include "player/options/opened_package.h"
#include "player/video/flight_frames.h"
#include "player/video/run_video.h"
#include "player/window/run_window.h"
#include "scene/error.h"
#include "scene/package_reader.h"

namespace vantage {
namespace {

void list_photos(const PackageReader& package) {
    const std::vector<Band> bands = read_bands(package);
    for (const package::PhotoRecord& p : package.photos())
        std::printf("%s  %s%s%ux%u  sees %.1f %% of the vertices%s\n", p.name, bands[p.band].name.c_str(),
                    bands.size() > 1 ? "  " : "", p.width, p.height, 100 * p.visible_vertices,
                    p.flags & package::photo_held_out ? "  held out" : "");
}

int show_in_headset([[maybe_unused]] const ShowOptions& options,
                    [[maybe_unused]] const std::vector<SceneObject>& objects) {
#ifdef VANTAGE_OPENXR
    return run_headset(options, objects);
#else
    throw Error(Exit::usage, "--xr: this vantage-player was built without OpenXR (libopenxr-dev)");
#endif
}

int show(const ShowOptions& options, const std::vector<SceneObject>& objects) {
    if (options.headset.on) return show_in_headset(options, objects);
    if (!options.window.kiosk) return run_window(options, objects);
    const auto run = [&](int signs) {
        ShowOptions watched = options;
        watched.window.signs = signs;
        try {
            return run_window(watched, objects);
        } catch (...) {
            return report_exception("vantage-player");
        }
    };
    return supervise(run, kiosk_log());
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
    app.get_option("FILE")->required(false)->description(
        "package: a file, or its URL on a server (http:// or https://); without one, a window that lists "
        "those opened before");
    add_object_options(app, o.objects);
    app.add_flag("--list", o.list, "list the photos and exit");
    add_output_options(app, o.output);
    add_memory_options(app, o.memory);
    add_blending_options(app, o.blending);
    add_second_band_options(app, o.blending.bands);
    add_layer_options(app, o.layer);
    add_light_options(app, o.light);
    add_point_options(app, o.points);
    add_picture_options(app, o.pictures);
    add_stereo_options(app, o.stereo);
    add_video_options(app, o.video);
    add_window_options(app, o.window);
    add_headset_options(app, o.headset);
    app.footer(
        "Examples:\n"
        "  vantage-player\n"
        "  vantage-player chapel.vantage\n"
        "  vantage-player chapel.vantage --offscreen --photo 0003 -o 0003.png\n"
        "  vantage-player chapel.vantage --offscreen --photo all --scale 0.5 --blend best -o pictures\n"
        "  vantage-player chapel.vantage --offscreen --view 4,-9,2,0,0,1,40 --size 1920x1080 -o view.png\n"
        "  vantage-player chapel.vantage --offscreen --photo 0003 --layer deviation --isolines 10 -o "
        "map.png\n"
        "  vantage-player chapel.vantage --offscreen --photo 0003 --light raking --lamp 200,10 -o "
        "relief.png\n"
        "  vantage-player chapel.vantage --offscreen --photo 0003 --panorama -o around.png\n"
        "  vantage-player chapel.vantage --offscreen --photo 0003 --stereo anaglyph -o 0003-3d.png\n"
        "  vantage-player chapel.vantage --turntable -o chapel.mp4\n"
        "  vantage-player chapel.vantage --tour short --size 1920x1080 -o tour.webm\n"
        "  vantage-player chapel.vantage --path chapel-0001.path --frame-rate 25 -o frames\n"
        "  vantage-player chapel.vantage --add altar.vantage --add scanner.vantage\n"
        "  vantage-player church.toml\n"
        "  vantage-player chapel.vantage --xr --unit-meters 0.01\n"
        "  vantage-player panel.vantage --offscreen --photo 0003 --band visible --band-mix infrared=0.5 -o "
        "mixed.png\n"
        "Verbs (vantage-player VERB --help):\n" +
        verbs_text() + exit_codes_text());
}

int show_command(int argc, char** argv) {
    CLI::App app{"vantage-player shows a prepared package: a scanned object through its own photos."};
    app.set_version_flag("--version", "vantage-player " VANTAGE_VERSION);
    ShowOptions options;
    add_show_options(app, options);
    if (const auto code = parse(app, argc, argv)) return *code;
    const bool video = wants_video(options);
    if (options.headset.on && (options.window.kiosk || options.list || options.pictures.offscreen || video))
        throw Error(Exit::usage, "--xr: neither with --kiosk nor with --list, pictures or videos");
    if (options.package.file.empty()) {
        if (options.list || options.pictures.offscreen || video || options.window.kiosk ||
            options.headset.on || !options.objects.added.empty())
            throw Error(Exit::usage, "expected a package: vantage-player FILE");
        return run_window(options, {});
    }
    const std::vector<SceneObject> objects = named_objects(options.package, options.objects);
    if (!options.list && !options.pictures.offscreen && !video) return show(options, objects);
    const PackageReader package =
        opened_package(objects.front().package, options.memory, options.output.quiet);
    package.meta();  // not needed for showing, but reports damage
    if (options.list) return list_photos(package), 0;
    return video ? run_video(package, options, objects) : run_offscreen(package, options, objects);
}

}  // namespace vantage
