#pragma once
#include <array>
#include <optional>
#include <vector>

#include "player/interface/overlays/glide.h"
#include "player/interface/state/drawn_frames.h"
#include "player/interface/state/message.h"
#include "player/interface/state/viewpoint.h"
#include "player/interface/state/window_state.h"
#include "player/render/render_settings.h"
#include "player/survey/footprint.h"
#include "player/survey/section.h"
#include "player/view/stereo.h"

namespace vantage {

/// Settings for cutting the model.
struct Cut {
    enum class By { plane, box, count } by = By::plane;
    /// The box that is kept, along the input's axes, in fractions of the model's extent.
    std::array<double, 3> low{0, 0, 0}, high{1, 1, 1};
    /// The plane's normal: the viewing direction at the time this option was selected, or an axis of the
    /// input.
    enum class Across { facing, x, y, z, count };
    bool on = false, other_side = false;
    Across across = Across::facing;
    Eigen::Vector3d facing = -Eigen::Vector3d::UnitZ();  ///< toward the viewer, of length 1
    double share = 0.5;  ///< position in the model's extent across the plane, 0 to 1
    KnownExtents extents;

    bool operator==(const Cut& o) const {
        return by == o.by && low == o.low && high == o.high && on == o.on && other_side == o.other_side &&
               across == o.across && facing == o.facing && share == o.share;
    }
};

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
    double flying_speed = 1;             ///< speed with the keys, in multiples of the default speed
    bool inertia = true;                 ///< drags released while moving continue
    bool near_photos = true;             ///< orbits and zooming out end where there are no photos
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
struct Session {
    /// `window` must outlive the session.
    explicit Session(WindowState& of) : window(of) {}

    WindowState& window;
    RenderSettings settings;
    std::vector<std::uint32_t> photos;  ///< allowed for blending
    StereoSettings stereo;              ///< settings for the pictures of two eyes
    bool freeze = false;                ///< weights are frozen
    bool lamp_follows = true;           ///< the raking light follows the pointer
    /// Whether the section of scalar fields is open for a package without stored fields.
    std::optional<bool> measured_fields;
    Viewpoint viewpoint;
    Steering steering;
    RecordedPath path;
    Cut cut;
    OrthophotoRequest orthophoto;
    PhotoList photo_list;
    Message message;
    DrawnFrames drawn;
};

/// The view from a camera, fitted to the free part of a frame of this size. If the session's projection is
/// orthographic, objects at the distance of the camera's target have the same size as in perspective.
View shown_view(const Navigation& camera, const Session& session, const PlanScene& scene, int width,
                int height);

/// Whether the section of scalar fields is open.
bool& fields_open(Session& session);

/// Starts a 0.7-second flight to a photo's camera.
void fly_to(Session& session, std::uint32_t photo, const package::PhotoRecord& record, double now);
/// Starts a flight to the view before the last movement.
void fly_back(Session& session, double now);
/// Ends a comparison, and starts a flight to the session's initial view.
void fly_home(Session& session, double now);

}  // namespace vantage
