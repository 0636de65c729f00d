#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "base/gl/object.h"
#include "player/measure/bench/process_memory.h"
#include "player/options/memory_options.h"
#include "player/options/output_options.h"
#include "player/options/shown/blending_options.h"
#include "player/options/shown/package_options.h"
#include "player/options/shown/point_options.h"
#include "player/options/stereo_options.h"
#include "player/render/timing/pass_clock.h"
#include "player/stream/streamed_so_far.h"
#include "player/view/camera_path.h"
#include "player/view/shots.h"
#include "scene/story/scene_file.h"

namespace vantage {

/// Duration of a frame on a path's clock, which controls fades.
inline constexpr double frame_seconds = 1.0 / 30;

/// Settings for flights along paths.
struct FlightOptions {
    PackageOptions package;
    std::vector<SceneObject> scene;  ///< the objects shown; the first is the package
    BlendingOptions blending;
    MemoryOptions memory;
    PointOptions points;
    StereoSettings stereo;  ///< frames are drawn in stereo unless off
    int frames = 120;
    double fps = -1;           ///< target rate in the mode "adaptive", see frame_goal()
    double minutes = 0;        ///< duration, instead of `frames`
    bool until_exact = false;  ///< end a path when the view is constant and its picture is exact
    bool warm = false;         ///< keep the package in the page cache
    std::filesystem::path folder = "bench";
};

struct FrameRecord {
    double ms;
    double scale;  ///< fraction of the frame's width and height at which it was drawn
    FrameReport report;
    std::uint64_t graphics;  ///< memory of OpenGL objects, bytes
    ProcessMemory process;
};

/// The measurements of one flight along a path.
struct Flight {
    std::string path, mode;
    int repeat;
    std::vector<FrameRecord> frames;
    PassTimes pass_ms{};  ///< times of the first object, summed over all frames
    StreamedSoFar streamed{};
    std::uint64_t graphics_budget = 0;
    // For the path "still" and the jump in the path "jump", if there is only one object:
    int frames_to_exact = -1;  ///< frames until no tile was missing; -1: never
    double ms_to_exact = 0;
    StreamedSoFar streamed_to_exact{};
    std::uint64_t touched_bytes = 0;
};
std::vector<double> frame_times(const Flight& flight);  ///< ms

/// The render target of a flight.
struct FlightTarget {
    FrameSize size;
    gl::Texture color;
    gl::Framebuffer framebuffer;
};
FlightTarget make_flight_target(FrameSize size);

/// A scripted path, or a path from a file of views. Scripted paths start at the first photo of --photo;
/// without that option, at the middle photo.
CameraPath path_named(const std::string& name, const PackageReader& package, const FlightOptions& options,
                      int repeat);

/// Flies a path over the scene's objects, of which `package` is the first, with new renderers. `mode`:
/// "stream", within the upload budget; "resident", with everything loaded in advance; "whole", uploading
/// complete photos when they are selected; "adaptive", like a moving window: within the upload budget, and
/// adapting quality to the requested frames per second. Throws Error.
Flight fly(const PackageReader& package, const FlightOptions& options, const CameraPath& path,
           const std::string& mode, int repeat, const FlightTarget& target);

}  // namespace vantage
