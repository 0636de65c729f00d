#pragma once
#include <Eigen/Geometry>
#include <string>

#include "scene/package/package_reader.h"

namespace vantage {

/// A plane to project the model on, at right angles: a point p of the input is shown at x = right . (p -
/// origin), y = up . (p - origin). The viewer is on the side of right x up, infinitely far away.
struct PicturePlane {
    Eigen::Vector3d origin = Eigen::Vector3d::Zero(), right,
                    up;  ///< the last two of length 1, at right angles
};

/// A plane by its name: top, bottom, front, back, left or right, as seen from there; through the origin of
/// the input's coordinates. `scene_up` is up in the scene. In the front view, x is to the right if it is
/// level; in the top view, as on a map, too: with z up, the front is seen along y, and the top has y upwards.
/// Or nine numbers separated by commas: a point of the plane, its normal toward the viewer, and what is up in
/// the picture; without the last three, `scene_up` is, or any direction if that is along the normal. Throws
/// Error(usage).
PicturePlane parse_plane(const std::string& text, const Eigen::Vector3d& scene_up);

/// The rectangle of the plane that the model's bounds cover.
Eigen::AlignedBox2d extent_on(const PicturePlane& plane, const package::SceneRecord& scene);
/// "LEFT,BOTTOM,RIGHT,TOP". Throws Error(usage).
Eigen::AlignedBox2d parse_extent(const std::string& text);

/// The six lines of a world file (ESRI): from columns and rows of a picture to x and y of the plane; of the
/// middle of its upper left pixel, and per pixel.
std::string world_file_text(const Eigen::Vector2d& upper_left, double resolution);

}  // namespace vantage
