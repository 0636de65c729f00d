#pragma once
#include "player/options/blending_options.h"
#include "player/options/headset_options.h"
#include "player/options/layer_options.h"
#include "player/options/light_options.h"
#include "player/options/memory_options.h"
#include "player/options/object_options.h"
#include "player/options/output_options.h"
#include "player/options/package_options.h"
#include "player/options/picture_options.h"
#include "player/options/point_options.h"
#include "player/options/stereo_options.h"
#include "player/options/video_options.h"
#include "player/options/window_options.h"

namespace vantage {

/// The command line of `vantage-player FILE`.
struct ShowOptions {
    PackageOptions package;
    ObjectOptions objects;
    BlendingOptions blending;
    LayerOptions layer;
    LightOptions light;
    PointOptions points;
    MemoryOptions memory;
    OutputOptions output;
    PictureOptions pictures;
    StereoSettings stereo;
    VideoOptions video;
    WindowOptions window;
    HeadsetOptions headset;
    bool list = false;
};

}  // namespace vantage
