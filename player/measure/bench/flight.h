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

/// Time from one frame to the next in a path's clock, which photos fade by.
inline constexpr double frame_seconds = 1.0 / 30;

/// How paths are flown.
struct FlightOptions {
    PackageOptions package;
    std::vector<SceneObject> scene;  ///< what is shown; the first object is the package
    BlendingOptions blending;
    MemoryOptions memory;
    PointOptions points;
    StereoSettings stereo;  ///< frames are drawn for both eyes unless off
    int frames = 120;
    double fps = -1;           ///< of the mode "adaptive", see frame_goal()
    double minutes = 0;        ///< instead of `frames`
    bool until_exact = false;  ///< end a path whose view stays the same when its picture is exact
    bool warm = false;         ///< keep the package in the page cache
    std::filesystem::path folder = "bench";
};

struct FrameRecord {
    double ms;
    double scale;  ///< share of the frame's width and height at which it was drawn
    FrameReport report;
    std::uint64_t graphics;  ///< bytes of OpenGL objects
    ProcessMemory process;
};

/// The measurements of one flight along a path.
struct Flight {
    std::string path, mode;
    int repeat;
    std::vector<FrameRecord> frames;
    PassTimes pass_ms{};  ///< of the first object, all frames together
    StreamedSoFar streamed{};
    std::uint64_t graphics_budget = 0;
    // Of "still", and of the jump in "jump", if there is a single object:
    int frames_to_exact = -1;  ///< until no tile was missing; -1: never
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

/// A scripted path, or one from a file of views. Scripted paths start at the first of --photo, or else at the
/// middle photo.
CameraPath path_named(const std::string& name, const PackageReader& package, const FlightOptions& options,
                      int repeat);

/// Flies a path over the scene's objects, of which `package` is the first, with fresh renderers. `mode`:
/// "stream", within the upload budget; "resident", everything loaded beforehand; "whole", each photo uploaded
/// whole when it is chosen; "adaptive", as a window moves: within the upload budget, and at the pace that
/// keeps the frames per second asked for. Throws Error.
Flight fly(const PackageReader& package, const FlightOptions& options, const CameraPath& path,
           const std::string& mode, int repeat, const FlightTarget& target);

}  // namespace vantage
