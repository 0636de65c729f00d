#include "player/options/frame_goal.h"

#include "base/cli/command.h"
#include "base/gl/context.h"

namespace vantage {

void add_fps_option(const Command& c, double& fps, const std::string& group) {
    c.real("--fps", fps, 0, 1000,
           "frames per second to keep in motion, by a lower resolution and fewer photos; 0: always in full "
           "(default 30, 15 with a software renderer; in a headset, as many as it shows)")
        .group(group);
}

double frame_goal(double fps) {
    if (fps < 0) fps = gl::current_device().software ? 15 : 30;
    return fps > 0 ? 1000 / fps : 0;
}

}  // namespace vantage
