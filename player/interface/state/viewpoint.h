#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "player/view/camera_spline.h"
#include "player/view/navigation.h"

namespace vantage {

/// The camera of a scene, and the flight in progress.
struct Viewpoint {
    Navigation camera;
    Navigation home;                ///< initial view of the session
    bool orthographic = false;      ///< instead of perspective
    std::uint32_t standing_at = 0;  ///< the photo last flown to

    /// A flight in progress: to a photo, along a recorded path, or along a curve with its own timing.
    struct Flight {
        std::vector<Navigation> stops;
        double start, seconds;
        std::shared_ptr<const CameraSpline> along{};
        bool repeats = false;                  ///< without end, as for auto-rotation
        double continued = start, waited = 0;  ///< time of the last frame; seconds of waiting at this stop
    };
    std::optional<Flight> flight;
    /// Views before each movement of the camera, oldest first.
    struct EarlierViews {
        std::vector<Navigation> views;
        Navigation last{};  ///< camera in the last frame
        double moved_at = 0;
        bool returning = false;  ///< the flight returns to one of `views`
    };
    EarlierViews earlier;
};

/// Sampling rate of recorded paths.
inline constexpr double positions_per_second = 30;

/// The camera's positions since the start of recording, sampled at the rate positions_per_second.
struct RecordedPath {
    bool recording = false;
    std::vector<Navigation> positions;
};

/// Starts at a camera, which becomes the home view.
void begin_at(Viewpoint& viewpoint, const Navigation& camera);
/// Starts a flight to a camera.
void start_flight(Viewpoint& viewpoint, const Navigation& to, double now, double seconds);
/// Starts a flight that covers half of the distance to a point.
void fly_to_point(Viewpoint& viewpoint, const Eigen::Vector3d& point, double now);
/// Whether the flight in progress is auto-rotation.
inline bool rotates(const Viewpoint& viewpoint) { return viewpoint.flight && viewpoint.flight->repeats; }
/// Starts a flight along the recorded path, at the recorded speed.
void replay(Viewpoint& viewpoint, const RecordedPath& path, double now);
/// Moves the camera to its position on the flight in progress. At the stops of a curve, the flight's time
/// does not pass until the picture is final, but for at most 15 seconds. `final`: whether the last picture
/// was.
void continue_flight(Viewpoint& viewpoint, double now, bool final = true);
/// The end of the flight in progress, in seconds.
std::optional<double> end_of_flight(const Viewpoint& viewpoint);
/// Stores the view from which the camera has just started to move.
void note_view(Viewpoint& viewpoint, double now);

/// Starts a new recording, or stops recording.
void toggle_recording(RecordedPath& path);

}  // namespace vantage
