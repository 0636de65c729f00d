#include "player/options/video_options.h"

#include "base/cli/command.h"

namespace vantage {

void add_video_options(const Command& c, VideoOptions& o) {
    const std::string group = "Video";
    const Option turntable =
        c.flag("--turntable", o.turntable,
               "turn around the whole model or, with --view or --photo, around the target of that view")
            .group(group);
    c.real("--arc", o.arc, 1, 360, "degrees of the turntable; below 360, the camera swings back and forth")
        .group(group)
        .needs(turntable);
    c.text("--tour", o.tour, "follow this tour of the package's story, given by its id or title")
        .group(group);
    c.real("--seconds", o.seconds, 0.01, 1e5,
           "duration of the video (default: that of the tour or the path; 12 for a turntable)")
        .group(group);
    c.real("--frame-rate", o.frame_rate, 1, 240, "frames per second of the video").group(group);
}

}  // namespace vantage
