#pragma once
#include <Eigen/Core>
#include <optional>

#include "player/view/view.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// A camera that the user moves: it orbits a target or flies. Coordinates are relative to the origin.
struct Navigation {
    Eigen::Vector3d eye, target, up;
    Eigen::Matrix3d R;  ///< cam_from_origin
    double fov = 45;    ///< vertical, degrees
    double aspect = 0;  ///< aspect ratio of the photo or other frame to which `fov` refers; 0: any
};

/// A position at the photo's camera, in its viewing direction. The target is as far away as the surface that
/// the photo sees.
Navigation stand_at(const package::PhotoRecord& photo, const Eigen::Vector3d& up);

/// A position at a view, with the target on its axis at `distance`.
Navigation stand_at(const View& view, const Eigen::Vector3d& up, double distance);

/// A position in front of the whole model, slightly elevated, with the target at the model's center; for
/// scenes without photos.
Navigation stand_before(const package::SceneRecord& scene, const Eigen::Vector3d& up);

/// A position in front of the whole model, in the viewing direction of a picture with these axes
/// (perpendicular unit vectors). `up`: the scene's up direction.
Navigation stand_beside(const package::SceneRecord& scene, const Eigen::Vector3d& right,
                        const Eigen::Vector3d& picture_up, const Eigen::Vector3d& up);

/// A position at the photo's camera, or in front of the model if the package has no photos.
Navigation home_of(const PackageReader& package, std::uint32_t photo);

/// The view that `prepare` chose for the scene. For an image set other than the chosen
/// photo's, the view is at the camera of the nearest photo in that set.
Navigation first_view(const PackageReader& package, std::uint32_t image_set);

/// Orbits the target by angles in radians: `right` about up, `down` about the camera's x axis. Stops 3
/// degrees from the poles.
void orbit(Navigation& n, double right, double down);
/// Like orbit(), about a point other than the target.
void orbit_about(Navigation& n, const Eigen::Vector3d& pivot, double right, double down);
/// The camera with the same direction and the up axis upright. Returns nullopt if that is within 0.1 degrees
/// of the present roll, or if the camera looks along the up axis.
std::optional<Navigation> leveled(const Navigation& n);
/// Turns the camera in place, by the same angles as orbit().
void look(Navigation& n, double right, double down);
/// Moves eye and target along the camera's axes (x right, y down, z ahead).
void fly(Navigation& n, const Eigen::Vector3d& step);
/// Scales the eye's distance from the target by `factor`, clamped to [0.01, 100].
void approach(Navigation& n, double factor);
/// Scales the distances of the eye and the target from a point, which keeps its position in the picture. The
/// eye's distance is clamped to [nearest, farthest].
void approach_point(Navigation& n, const Eigen::Vector3d& point, double factor, double nearest,
                    double farthest);
/// The camera that sees a point from the same direction as before, at this distance and in the center. The
/// point becomes the target.
Navigation facing(const Navigation& n, const Eigen::Vector3d& point, double distance);

View view_of(const Navigation& n, int width, int height);
/// Like view_of(), but with the field of view, which is `fov` high and `aspect` times as wide, fitted into
/// the part `free` of the frame and centered there. `free` is enlarged to at least one pixel.
View view_of(const Navigation& n, int width, int height, const Area& free);

}  // namespace vantage
