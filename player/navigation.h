#pragma once
#include <Eigen/Core>

#include "player/view.h"

namespace vantage {

/// A camera that people move: it turns about a target, or flies. Coordinates relative to the origin.
struct Navigation {
    Eigen::Vector3d eye, target, up;
    Eigen::Matrix3d R;  ///< cam_from_origin
    double fov = 45;    ///< vertical, degrees
};

/// Standing where the photo was taken, looking as it did, turning about what it sees.
Navigation stand_at(const package::PhotoRecord& photo, const Eigen::Vector3d& up);

/// Turns about the target by angles in radians: `right` about up, `down` about the camera's x axis. Stops
/// short of the poles.
void orbit(Navigation& n, double right, double down);
/// Turns the camera in place.
void look(Navigation& n, double right, double down);
/// Moves eye and target along the camera's axes (x right, y down, z ahead).
void fly(Navigation& n, const Eigen::Vector3d& step);
/// Eye to `factor` times its distance from the target; never into it.
void approach(Navigation& n, double factor);

View view_of(const Navigation& n, int width, int height);

}  // namespace vantage
