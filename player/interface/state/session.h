#pragma once
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "player/interface/overlays/glide.h"
#include "player/interface/state/drawn_frames.h"
#include "player/interface/state/message.h"
#include "player/interface/state/session_settings.h"
#include "player/interface/state/viewpoint.h"
#include "player/interface/state/window_state.h"
#include "player/survey/footprint.h"

namespace vantage {

/// A request to write an orthophoto.
struct OrthophotoRequest {
    enum class Plane { top, front, back, left, right, facing, count } plane = Plane::front;
    double pixel = 0;  ///< pixel size in input units; 0: not chosen yet
    enum class File { png, tiff, count } file = File::png;
    bool writing = false;
};

/// The list of all photos.
struct PhotoList {
    std::array<char, 100> filter{};  ///< part of a name
    bool worst_first = false;
    std::vector<std::optional<double>> errors;  ///< errors of all photos, pixels; see photo_errors()
    bool by_point = false;                      ///< lists only photos that show a clicked point
    std::optional<Eigen::Vector3d> point;
    std::vector<Footprint> showing;  ///< the photos that show the point
};

/// State of camera control by keys, drags and touch.
struct Steering {
    std::optional<Navigation> inside{};  ///< the camera before the drag in progress left the photos
    Glide glide;
    /// The anchor of a drag or a two-finger gesture.
    struct Grip {
        Eigen::Vector3d pivot;  ///< the point under the pointer when the drag began
        bool looks = false;     ///< the drag turns the camera in place
    };
    std::optional<Grip> grip;
};

/// State of a scene as the user views and edits it, in a window that may show other scenes before and after
/// it.
struct Session : SessionSettings {
    /// `window` must outlive the session.
    explicit Session(WindowState& of) : window(of) {}

    WindowState& window;
    SessionSettings defaults;  ///< those of the program and the command line, for resets
    Viewpoint viewpoint;
    Steering steering;
    RecordedPath path;
    OrthophotoRequest orthophoto;
    PhotoList photo_list;
    Message message;
    DrawnFrames drawn;
};

/// The view from a camera, fitted to the picture's area in a frame of this size. If the session's projection
/// is orthographic, objects at the distance of the camera's target have the same size as in perspective.
View shown_view(const Navigation& camera, const Session& session, const PlanScene& scene, int width,
                int height);

/// Starts a 0.7-second flight to a photo's camera.
void fly_to(Session& session, std::uint32_t photo, const package::PhotoRecord& record, double now);
/// Starts a flight to the view before the last movement.
void fly_back(Session& session, double now);
/// Starts a flight that removes the camera's roll, if there is any.
void fly_level(Session& session, double now);
/// Starts or stops auto-rotation: the camera turns slowly about its target, back and forth if the session
/// stays near the photos and they do not surround the target.
void toggle_rotation(Session& session, std::span<const package::PhotoRecord> photos, double now);
/// Ends a comparison, and starts a flight to the session's initial view.
void fly_home(Session& session, double now);

}  // namespace vantage
