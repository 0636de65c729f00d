#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "base/cli/report_exception.h"
#include "player/verbs/offscreen.h"
#include "player/verbs/supervise.h"
#include "player/verbs/verbs.h"
#include "scene/package/contents/image_sets.h"
#ifdef VANTAGE_OPENXR
#include "player/headset/run_headset.h"
#endif
#include "base/text/error.h"
#include "base/text/lower_extension.h"
#include "player/options/shown/opened_package.h"
#include "player/pictures/flight_frames.h"
#include "player/pictures/run_video.h"
#include "player/window/run_window.h"
#include "scene/package/package_reader.h"

namespace vantage {
namespace {

void list_photos(const PackageReader& package) {
    const std::vector<ImageSet> image_sets = read_image_sets(package);
    for (const package::PhotoRecord& p : package.photos())
        std::printf("%s  %s%s%ux%u  sees %.1f %% of the vertices%s\n", p.name,
                    image_sets[p.image_set].name.c_str(), image_sets.size() > 1 ? "  " : "", p.width,
                    p.height, 100 * p.visible_vertices,
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
    const auto run = [&](int heartbeat_fd) {
        ShowOptions watched = options;
        watched.window.heartbeat_fd = heartbeat_fd;
        try {
            return run_window(watched, objects);
        } catch (...) {
            return report_exception("vantage-player");
        }
    };
    return supervise(run, kiosk_log());
}

int show_or_write(const ShowOptions& o) {
    const bool video = wants_video(o);
    if (o.headset.on && (o.window.kiosk || o.list || o.pictures.offscreen || video))
        throw Error(Exit::usage, "--xr: neither with --kiosk nor with --list, pictures or videos");
    if (!o.window.screenshot.empty() && lower_extension(o.window.screenshot) != ".png")
        throw Error(Exit::usage,
                    "--screenshot: " + o.window.screenshot + ": expected a name that ends with .png");
    if (o.package.file.empty()) {
        if (o.list || o.pictures.offscreen || video || o.window.kiosk || o.headset.on ||
            !o.objects.added.empty())
            throw Error(Exit::usage, "expected a package: vantage-player FILE");
        return run_window(o, {});
    }
    const std::vector<SceneObject> objects = named_objects(o.package, o.objects);
    if (!o.list && !o.pictures.offscreen && !video) return show(o, objects);
    const PackageReader package = opened_package(objects.front().package, o.memory, o.output.quiet);
    package.meta();  // not needed for showing, but reports damage
    if (o.list) return list_photos(package), 0;
    return video ? run_video(package, o, objects) : run_offscreen(package, o, objects);
}

}  // namespace

void add_show(const Command& c) {
    const auto o = std::make_shared<ShowOptions>();
    add_package_argument(c, o->package, "; without one, a window that lists those opened before");
    add_exclude_option(c, o->package);
    add_photo_option(c, o->package);
    add_object_options(c, o->objects);
    c.flag("--list", o->list, "list the photos and exit");
    add_size_option(c, o->output);
    add_output_options(c, o->output);
    add_quiet_option(c, o->output);
    add_memory_options(c, o->memory);
    add_upload_option(c, o->memory);
    add_blending_options(c, o->blending);
    add_blended_option(c, o->blending);
    add_holes_option(c, o->blending);
    add_background_option(c, o->blending);
    add_transparency_option(c, o->blending);
    add_second_image_set_options(c, o->blending.image_sets);
    add_field_options(c, o->field);
    add_light_options(c, o->light);
    add_point_options(c, o->points);
    add_picture_options(c, o->pictures);
    add_stereo_options(c, o->stereo);
    add_video_options(c, o->video);
    add_window_options(c, o->window);
    add_headset_options(c, o->headset);
    c.common({"--help", "--help-all", "--photo", "--view", "--offscreen", "--turntable", "--size", "--scale",
              "--output", "--list", "--kiosk", "--graphics-memory"});
    c.notes(
        "Examples:\n"
        "  vantage-player\n"
        "  vantage-player chapel.vantage\n"
        "  vantage-player chapel.vantage --offscreen --photo 0003 -o 0003.png\n"
        "  vantage-player chapel.vantage --turntable -o chapel.mp4\n"
        "  vantage-player chapel.vantage --kiosk --idle-timeout 90\n"
        "  vantage-player church.toml\n"
        "  vantage-player chapel.vantage --offscreen --photo all --scale 0.5 --blend best -o pictures\n"
        "  vantage-player chapel.vantage --offscreen --view 4,-9,2,0,0,1,40 --size 1920x1080 -o view.png\n"
        "  vantage-player chapel.vantage --offscreen --photo 0003 --field deviation --isolines 10 -o "
        "map.png\n"
        "  vantage-player chapel.vantage --offscreen --photo 0003 --light raking --lamp 200,10 -o "
        "relief.png\n"
        "  vantage-player chapel.vantage --offscreen --photo 0003 --panorama -o around.png\n"
        "  vantage-player chapel.vantage --offscreen --photo 0003 --stereo anaglyph -o 0003-3d.png\n"
        "  vantage-player chapel.vantage --tour short --size 1920x1080 -o tour.webm\n"
        "  vantage-player chapel.vantage --path chapel-0001.path --frame-rate 25 -o frames\n"
        "  vantage-player chapel.vantage --add altar.vantage --add scanner.vantage\n"
        "  vantage-player chapel.vantage --xr --meters-per-unit 0.01\n"
        "  vantage-player panel.vantage --offscreen --photo 0003 --image-set visible --second-image-set "
        "infrared=0.5 "
        "-o "
        "mixed.png\n" +
        exit_codes_text());
    c.action([o](const Command& given) {
        o->blending.given = given.given(blending_group);
        return show_or_write(*o);
    });
}

}  // namespace vantage
