#pragma once
#include <memory>

#include "player/options/headset_options.h"
#include "player/options/memory_options.h"
#include "player/options/output_options.h"
#include "player/options/picture_options.h"
#include "player/options/shown/blending_options.h"
#include "player/options/shown/field_options.h"
#include "player/options/shown/light_options.h"
#include "player/options/shown/object_options.h"
#include "player/options/shown/package_options.h"
#include "player/options/shown/point_options.h"
#include "player/options/stereo_options.h"
#include "player/options/video_options.h"
#include "player/options/window_options.h"

namespace vantage {

/// The options of the commands that show or draw a scene; each verb adds some of them.
struct ShowOptions {
    PackageOptions package;
    ObjectOptions objects;
    BlendingOptions blending;
    FieldOptions field;
    LightOptions light;
    PointOptions points;
    MemoryOptions memory;
    OutputOptions output;
    PictureOptions pictures;
    StereoSettings stereo;
    VideoOptions video;
    WindowOptions window;
    HeadsetOptions headset;
};

/// The common options of verbs that draw a scene, except the package and the output.
void add_scene_options(const Command& command, ShowOptions& options);
/// Makes a command call `show` with `options`, in which it first records whether a blending option was given.
void show_by(const Command& command, const std::shared_ptr<ShowOptions>& options,
             int (*show)(const ShowOptions& options));

}  // namespace vantage
