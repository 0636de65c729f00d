#pragma once
#include <string>
#include <vector>

#include "player/options/blending_options.h"
#include "player/options/layer_options.h"
#include "player/options/light_options.h"
#include "player/options/memory_options.h"
#include "player/options/output_options.h"
#include "player/options/package_options.h"
#include "player/options/picture_options.h"
#include "player/options/point_options.h"
#include "player/options/window_options.h"

namespace vantage {

/// The command line of `vantage-player FILE`.
struct ShowOptions {
    PackageOptions package;
    BlendingOptions blending;
    LayerOptions layer;
    LightOptions light;
    PointSettings points;
    MemoryOptions memory;
    OutputOptions output;
    PictureOptions pictures;
    WindowOptions window;
    std::vector<std::string> added;  ///< packages to show with it
    bool list = false;
};

}  // namespace vantage
