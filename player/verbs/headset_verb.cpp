#include "base/text/error.h"
#include "player/verbs/verbs.h"
#ifdef VANTAGE_OPENXR
#include "player/headset/run_headset.h"
#endif

namespace vantage {
namespace {

int show_in_headset([[maybe_unused]] const ShowOptions& o) {
#ifdef VANTAGE_OPENXR
    return run_headset(o, named_objects(o.package, o.objects));
#else
    throw Error(Exit::usage, "headset: this vantage-player was built without OpenXR (libopenxr-dev)");
#endif
}

}  // namespace

void add_headset(const Command& program) {
    const auto o = std::make_shared<ShowOptions>();
    const Command c = program.verb("headset", "Show a package in a headset (OpenXR)");
    add_package_argument(c, o->package).required();
    add_headset_options(c, o->headset);
    add_scene_options(c, *o);
    add_photo_option(c, o->package, "photo whose camera is the first view");
    add_view_option(c, o->pictures);
    add_upload_option(c, o->memory);
    add_window_options(c, o->window);
    c.notes(
        "A window shows a copy of the picture in the headset.\n"
        "Example:\n"
        "  vantage-player headset chapel.vantage --meters-per-unit 0.01");
    show_by(c, o, show_in_headset);
}

}  // namespace vantage
