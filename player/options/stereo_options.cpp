#include "player/options/stereo_options.h"

#include "base/cli/command.h"

namespace vantage {

void add_stereo_options(const Command& c, StereoSettings& s) {
    const std::string group = "Two eyes";
    const Option mode =
        c.choice("--stereo", s.mode,
                 {{"off", StereoMode::off},
                  {"side-by-side", StereoMode::side_by_side},
                  {"over-under", StereoMode::over_under},
                  {"anaglyph", StereoMode::anaglyph},
                  {"checkerboard", StereoMode::checkerboard}},
                 "pictures for two eyes: side-by-side (the left one first), over-under (the left one above), "
                 "anaglyph (red and cyan glasses), checkerboard (3D displays); --size is the size of each "
                 "eye's picture, or of the window")
            .group(group);
    c.real("--eye-separation", s.eyes.distance, 1e-9, 1e9,
           "distance between the eyes, in scene units (default: a thirtieth of the convergence distance)")
        .group(group)
        .needs(mode);
    c.real("--convergence", s.eyes.convergence, 1e-9, 1e9,
           "depth that appears at the screen, in scene units; nearer objects appear in front of the screen "
           "(default: depth of the view's target)")
        .group(group)
        .needs(mode);
}

}  // namespace vantage
