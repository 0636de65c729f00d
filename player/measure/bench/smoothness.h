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
    std::string path;   ///< file of views; empty: through the photos' cameras
    double step = 0.5;  ///< degrees per frame
    bool fades = true;  ///< photos fade in and out as in a window
    int worst = 1;      ///< frames to save as PNG
    std::filesystem::path folder = "smoothness";
};

/// The step from one frame of a path to the next.
struct FrameStep {
    ColorStep color;
    std::size_t photos = 0,
                changed = 0;  ///< drawn in the next frame; of them or of this frame's, not in both
    std::size_t tiles_missing = 0;
};

/// The mean over frames, the worst hundredth, and the worst of each frame's mean over the picture and of
/// what the worst hundredth of the picture exceeds, in gray levels; and their sums per degree.
struct Smoothness {
    FrameStatistics mean, patches;
    double degrees = 0, mean_per_degree = 0, patches_per_degree = 0;
    std::size_t worst = 0;  ///< the frame before the largest step of a patch
};
Smoothness smoothness_of(const std::vector<FrameStep>& steps);

/// A frame as it was, with the photos and weights of the next, and how the step was.
struct ShownStep {
    std::size_t frame;
    double patches;
    Picture now, then;
};

/// Flies a path, with every tile in place. Keeps the `worst` largest steps in `shown`, the largest first.
/// Belongs to the OpenGL thread.
std::vector<FrameStep> fly_in_steps(const PackageReader& package, const SmoothnessOptions& options,
                                    const std::vector<Navigation>& path, FrameSize size,
                                    std::vector<ShownStep>& shown);

/// Measures how far the colors of surfaces jump from frame to frame; prints a summary and writes steps.csv,
/// summary.json, steps.svg and the worst steps as PNG. Throws Error.
int run_smoothness(const PackageReader& package, const SmoothnessOptions& options);

}  // namespace vantage
