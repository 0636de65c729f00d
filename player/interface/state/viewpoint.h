#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "player/view/camera_spline.h"
#include "player/view/navigation.h"

namespace vantage {

/// Where a scene is seen from, and the flight that changes it.
struct Viewpoint {
    Navigation camera;
    Navigation home;                ///< where the session began
    bool orthographic = false;      ///< instead of perspective
    std::uint32_t standing_at = 0;  ///< the photo last flown to

    /// A flight in progress: to a photo, along a recorded path, or along a curve with times of its own.
    struct Flight {
        std::vector<Navigation> stops;
        double start, seconds;
        std::shared_ptr<const CameraSpline> along{};
    };
    std::optional<Flight> flight;
    /// Where the camera was before it moved, oldest first.
    struct EarlierViews {
        std::vector<Navigation> views;
        Navigation last{};  ///< of the last frame
        double moved_at = 0;
        bool returning = false;  ///< the flight leads to one of them
    };
    EarlierViews earlier;
};

/// How often positions are recorded.
inline constexpr double positions_per_second = 30;

/// The camera's positions since recording was started, one per 1 / positions_per_second seconds.
struct RecordedPath {
    bool recording = false;
    std::vector<Navigation> positions;
};

/// Begins at a camera, which is home.
void begin_at(Viewpoint& viewpoint, const Navigation& camera);
/// Starts a flight to a camera.
void start_flight(Viewpoint& viewpoint, const Navigation& to, double now, double seconds);
/// Starts a flight that ends before a point, at half the distance.
void fly_to_point(Viewpoint& viewpoint, const Eigen::Vector3d& point, double now);
/// Starts a flight along the recorded path, as fast as it was recorded.
void replay(Viewpoint& viewpoint, const RecordedPath& path, double now);
/// Moves the camera to its position on the flight in progress.
void continue_flight(Viewpoint& viewpoint, double now);
/// Remembers the view from which the camera has just started to move.
void note_view(Viewpoint& viewpoint, double now);

/// Starts recording anew, or stops.
void toggle_recording(RecordedPath& path);

}  // namespace vantage
