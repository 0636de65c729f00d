#include "player/options/shown/opened_package.h"
#include "player/pictures/run_video.h"
#include "player/verbs/verbs.h"

namespace vantage {
namespace {

int write_video(const ShowOptions& o) {
    const std::vector<SceneObject> objects = named_objects(o.package, o.objects);
    return run_video(opened_package(objects.front().package, o.memory), o, objects);
}

}  // namespace

void add_video(const Command& program) {
    const auto o = std::make_shared<ShowOptions>();
    const Command c = program.verb("video", "Write a video of a turntable, a tour or a path");
    add_package_argument(c, o->package).required();
    add_video_options(c, o->video);
    add_path_option(c, o->pictures,
                    "a video that flies along them, each at its at=SECONDS, or 3 seconds apart");
    add_photo_option(c, o->package, "photo whose camera is the start of the turntable");
    add_view_option(c, o->pictures);
    add_output_options(c, o->output);
    add_samples_option(c, o->pictures);
    add_legend_option(c, o->pictures);
    add_scene_options(c, *o);
    add_stereo_options(c, o->stereo);
    c.common({"--help", "--help-all", "--turntable", "--arc", "--tour", "--path", "--seconds", "--frame-rate",
              "--output", "--size", "--view", "--photo", "--max-photos", "--holes", "--stereo"});
    c.notes(
        "Writes MP4 or WebM, encoded by ffmpeg. If the output is a folder, writes a PNG per frame.\n"
        "Examples:\n"
        "  vantage-player video chapel.vantage --turntable -o chapel.mp4\n"
        "  vantage-player video chapel.vantage --turntable --arc 60 --photo 0003 -o chapel.webm\n"
        "  vantage-player video chapel.vantage --tour short --size 1920x1080 -o tour.webm\n"
        "  vantage-player video chapel.vantage --path chapel-0001.path --frame-rate 25 -o frames");
    c.action([o] { return write_video(*o); });
}

}  // namespace vantage
