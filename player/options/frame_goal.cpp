#include "player/options/frame_goal.h"

#include "base/cli/command.h"
#include "base/gl/context.h"

namespace vantage {

void add_fps_option(const Command& c, double& fps, const std::string& group) {
    c.real("--fps", fps, 0, 1000,
           "target frame rate in motion, reached by lowering the resolution and blending fewer photos; 0: "
           "always full frames (default 30, 15 with a software renderer; in a headset, its refresh rate)")
        .group(group);
}

double frame_goal(double fps) {
    if (fps < 0) fps = gl::current_device().software ? 15 : 30;
    return fps > 0 ? 1000 / fps : 0;
}

}  // namespace vantage
