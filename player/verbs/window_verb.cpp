#include "base/cli/report_exception.h"
#include "base/text/error.h"
#include "base/text/lower_extension.h"
#include "player/verbs/supervise.h"
#include "player/verbs/verbs.h"
#include "player/window/run_window.h"

namespace vantage {
namespace {

int open_window(const ShowOptions& o) {
    if (!o.window.screenshot.empty() && lower_extension(o.window.screenshot) != ".png")
        throw Error(Exit::usage,
                    "--screenshot: " + o.window.screenshot + ": expected a name that ends with .png");
    if (o.package.file.empty() && !o.objects.added.empty())
        throw Error(Exit::usage, "--add: expected a package: vantage-player FILE");
    const bool in_window = o.package.file.empty() || o.window.errors_in_window;
    return run_window(o, in_window ? std::vector<SceneObject>{} : named_objects(o.package, o.objects));
}

int open_kiosk(const ShowOptions& given) {
    ShowOptions o = given;
    o.window.kiosk = true;
    const std::vector<SceneObject> objects = named_objects(o.package, o.objects);
    const auto run = [&](int heartbeat_fd) {
        o.window.heartbeat_fd = heartbeat_fd;
        try {
            return run_window(o, objects);
        } catch (...) {
            return report_exception("vantage-player");
        }
    };
    return supervise(run, kiosk_log());
}

void add_shown_options(const Command& c, ShowOptions& o) {
    add_scene_options(c, o);
    add_photo_option(c, o.package, "photo whose camera is the window's first view");
    add_view_option(c, o.pictures);
    add_upload_option(c, o.memory);
    add_stereo_options(c, o.stereo);
    add_window_options(c, o.window);
}

}  // namespace

void add_window(const Command& program) {
    const auto o = std::make_shared<ShowOptions>();
    add_package_argument(program, o->package, "; without a file, the window lists recent packages");
    program.quiet();
    add_shown_options(program, *o);
    program
        .flag("--errors-in-window", o->window.errors_in_window,
              "if FILE cannot be opened, show the start page with the reason, as file managers need it")
        .group("Window");
    program.common({"--help", "--help-all", "--version", "--photo", "--view", "--size", "--add",
                    "--no-saved-settings", "--graphics-memory", "--language"});
    program.notes(
        "Examples:\n"
        "  vantage-player chapel.vantage\n"
        "  vantage-player render chapel.vantage --photo 0003 -o 0003.png\n"
        "  vantage-player video chapel.vantage --turntable -o chapel.mp4\n"
        "  vantage-player kiosk chapel.vantage --idle-timeout 90\n"
        "  vantage-player evaluate chapel.vantage -o evaluation\n"
        "  vantage-player help render\n"
        "  vantage-player church.toml\n"
        "  vantage-player chapel.vantage --add altar.vantage --add scanner.vantage\n" +
        exit_codes_text());
    show_by(program, o, open_window);
}

void add_kiosk(const Command& program) {
    const auto o = std::make_shared<ShowOptions>();
    const Command c = program.verb("kiosk", "Show a package to the public, full screen");
    add_package_argument(c, o->package).required();
    add_kiosk_options(c, o->window);
    add_shown_options(c, *o);
    c.notes(
        "Visitors can neither quit nor open files or settings. The player is restarted if it fails; SIGTERM "
        "ends it.\n"
        "Its log is ~/.local/state/vantage/kiosk.log.\n"
        "Examples:\n"
        "  vantage-player kiosk chapel.vantage\n"
        "  vantage-player kiosk chapel.vantage --idle-timeout 90 --attract chapel-0001.path --language de");
    show_by(c, o, open_kiosk);
}

}  // namespace vantage
