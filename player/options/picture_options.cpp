#include "player/options/picture_options.h"

#include "base/cli/command.h"

namespace vantage {

void add_view_option(const Command& c, PictureOptions& o) {
    c.text("--view", o.view,
           "view from EX,EY,EZ to TX,TY,TZ, optionally with the vertical field of view and the camera's "
           "clockwise roll in degrees (180: upside down)");
}

void add_path_option(const Command& c, PictureOptions& o, const std::string& help) {
    c.file("--path", o.path, "file of views, one per line, as for --view: " + help);
}

void add_samples_option(const Command& c, PictureOptions& o) {
    c.integer("--samples", o.samples, 1, 8,
              "samples per side of a pixel (default 2; 1 for views from a photo's own camera at full size)");
}

void add_legend_option(const Command& c, PictureOptions& o) {
    c.choice("--legend", o.legend, {{"auto", true}, {"off", false}},
             "legend of a scalar field: auto (drawn into pictures that are large enough, except panoramas "
             "and stereo), off");
}

void add_picture_options(const Command& c, PictureOptions& o) {
    c.real("--scale", o.scale, 0.001, 8, "size of the picture relative to the photo");
    c.flag("--panorama", o.panorama,
           "all directions around the eye in one picture, for panorama viewers (equirectangular; --size "
           "is twice as wide as high, by default 4096x2048); with --stereo over-under, for two eyes");
}

}  // namespace vantage
