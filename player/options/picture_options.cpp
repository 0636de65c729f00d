#include "player/options/picture_options.h"

#include "cli/real_range.h"

namespace vantage {

void add_picture_options(CLI::App& app, PictureOptions& o) {
    const std::string group = "Pictures without a display";
    app.add_flag("--offscreen", o.offscreen, "render to PNG instead of opening a window")->group(group);
    app.add_option("--view", o.view,
                   "view from EX,EY,EZ to TX,TY,TZ, optionally with the vertical field of view in degrees; "
                   "of a window, the first one")
        ->group(group);
    app.add_option("--path", o.path,
                   "file of views, one per line, as for --view; without --offscreen, a video along them, "
                   "each at its at=SECONDS, or 3 seconds apart")
        ->type_name("FILE")
        ->group(group);
    app.add_option("--scale", o.scale, "size of the picture relative to the photo's")
        ->check(real_range(0.001, 8.0))
        ->capture_default_str()
        ->group(group);
    app.add_flag("--panorama", o.panorama,
                 "all directions around the eye in one picture, for viewers of panoramas (equirectangular; "
                 "--size is twice as wide as high, by default 4096x2048); with --stereo over-under, for two "
                 "eyes")
        ->group(group);
    app.add_option("--samples", o.samples,
                   "samples per side of a pixel (default 2; 1 from a photo's own camera at full size)")
        ->check(CLI::Range(1, 8))
        ->group(group);
}

}  // namespace vantage
