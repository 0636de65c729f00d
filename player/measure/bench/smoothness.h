#pragma once
#include "player/measure/bench/color_step.h"
#include "player/measure/bench/flight.h"
#include "player/render/timing/frame_statistics.h"

namespace vantage {

/// The command line of `vantage-player smoothness`.
struct SmoothnessOptions {
    PackageOptions package;
    BlendingOptions blending;
    MemoryOptions memory;
    OutputOptions output;
    std::string path;   ///< file of views; empty: the path leads past the photos' cameras
    double step = 0.5;  ///< degrees per frame
    bool fades = true;  ///< photos fade in and out as in a window
    int worst = 1;      ///< number of frames to save as PNG
    std::filesystem::path folder = "smoothness";
};

/// The change from one frame of a path to the next.
struct FrameStep {
    ColorStep color;
    std::size_t photos = 0,
                changed = 0;  ///< photos drawn in the next frame; photos drawn in only one of the two frames
    std::size_t tiles_missing = 0;
};

/// Statistics over the frames, in gray levels: of each frame's mean change (`mean`) and of the 99th
/// percentile over its cells (`patches`). Also the sums of these two values, divided by the path's degrees.
struct Smoothness {
    FrameStatistics mean, patches;
    double degrees = 0, mean_per_degree = 0, patches_per_degree = 0;
    std::size_t worst = 0;  ///< index of the frame before the largest change in a cell
};
Smoothness smoothness_of(const std::vector<FrameStep>& steps);

/// A frame, a frame of the same view with the photos and weights of the next frame, and the change between
/// the two.
struct ShownStep {
    std::size_t frame;
    double patches;
    Picture now, then;
};

/// Flies a path with all tiles loaded. Stores the `worst` largest changes in `shown`, largest first. Must be
/// called on the OpenGL thread.
std::vector<FrameStep> fly_in_steps(const PackageReader& package, const SmoothnessOptions& options,
                                    const std::vector<Navigation>& path, FrameSize size,
                                    std::vector<ShownStep>& shown);

/// Measures changes in surface colors from frame to frame; prints a summary and writes steps.csv,
/// summary.json, steps.svg and the largest changes as PNG. Throws Error.
int run_smoothness(const PackageReader& package, const SmoothnessOptions& options);

}  // namespace vantage
