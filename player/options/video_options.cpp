#include "player/options/video_options.h"

#include "cli/real_range.h"

namespace vantage {

void add_video_options(CLI::App& app, VideoOptions& o) {
    const std::string group = "Videos without a display";
    app.add_flag("--turntable", o.turntable,
                 "a video around the whole model, or from --view or --photo around what is seen there")
        ->group(group);
    app.add_option("--arc", o.arc,
                   "degrees of the turntable; below 360, the camera swings to both sides and back")
        ->check(real_range(1.0, 360.0))
        ->capture_default_str()
        ->group(group);
    app.add_option("--tour", o.tour, "a video of this tour of the package's story, by its id or title")
        ->group(group);
    app.add_option("--seconds", o.seconds,
                   "length of the video (default: that of the tour or the path; of a turntable, 12)")
        ->check(real_range(0.01, 1e5))
        ->group(group);
    app.add_option("--frame-rate", o.frame_rate, "frames per second of the video")
        ->check(real_range(1.0, 240.0))
        ->capture_default_str()
        ->group(group);
}

}  // namespace vantage
