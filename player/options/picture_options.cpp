#include "player/options/picture_options.h"

#include "base/cli/command.h"

namespace vantage {

void add_picture_options(const Command& c, PictureOptions& o) {
    const std::string group = "Pictures without a display";
    c.flag("--offscreen", o.offscreen, "render to PNG instead of opening a window").group(group);
    c.text("--view", o.view,
           "view from EX,EY,EZ to TX,TY,TZ, optionally with the vertical field of view in degrees; of a "
           "window, the first one")
        .group(group);
    c.file("--path", o.path,
           "file of views, one per line, as for --view; without --offscreen, a video along them, each at its "
           "at=SECONDS, or 3 seconds apart")
        .group(group);
    c.real("--scale", o.scale, 0.001, 8, "size of the picture relative to the photo's").group(group);
    c.flag("--panorama", o.panorama,
           "all directions around the eye in one picture, for viewers of panoramas (equirectangular; --size "
           "is twice as wide as high, by default 4096x2048); with --stereo over-under, for two eyes")
        .group(group);
    c.integer("--samples", o.samples, 1, 8,
              "samples per side of a pixel (default 2; 1 from a photo's own camera at full size)")
        .group(group);
}

}  // namespace vantage
