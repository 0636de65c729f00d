#include "player/options/stereo_options.h"

#include "cli/real_range.h"

namespace vantage {

void add_stereo_options(CLI::App& app, StereoSettings& s) {
    const std::string group = "Two eyes";
    const std::map<std::string, StereoMode> modes{{"off", StereoMode::off},
                                                  {"side-by-side", StereoMode::side_by_side},
                                                  {"over-under", StereoMode::over_under},
                                                  {"anaglyph", StereoMode::anaglyph},
                                                  {"checkerboard", StereoMode::checkerboard}};
    CLI::Option* mode =
        app.add_option("--stereo", s.mode,
                       "pictures for two eyes: side-by-side (the left one first), over-under (the left one "
                       "above), anaglyph (red and cyan glasses), checkerboard (3D displays); --size is that "
                       "of each eye's picture, or of the window")
            ->transform(CLI::CheckedTransformer(modes))
            ->default_str("off")
            ->group(group);
    app.add_option("--eye-distance", s.eyes.distance,
                   "between the eyes, in scene units (default: a thirtieth of the convergence)")
        ->check(real_range(1e-9, 1e9))
        ->group(group)
        ->needs(mode);
    app.add_option("--convergence", s.eyes.convergence,
                   "depth that appears at the screen, in scene units; nearer things come out of it (default: "
                   "that of what the view looks at)")
        ->check(real_range(1e-9, 1e9))
        ->group(group)
        ->needs(mode);
}

}  // namespace vantage
