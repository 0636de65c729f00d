#pragma once
#include <Eigen/Geometry>
#include <string>

#include "player/plan/section_plane.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// A plane for the orthogonal projection of the model: a point p of the input is at x = right . (p - origin),
/// y = up . (p - origin). The viewer is on the side of right x up, infinitely far away.
struct PicturePlane {
    Eigen::Vector3d origin = Eigen::Vector3d::Zero(), right,
                    up;  ///< right and up are perpendicular unit vectors
};

/// Parses the name of a plane through the origin of the input coordinates: top, bottom, front, back, left or
/// right, viewed from that side. `scene_up` is the scene's up direction. If the x axis is horizontal, it
/// points right in the front view and, as on a map, in the top view: with z up, the front view looks along y,
/// and y points upward in the top view. Also parses nine numbers separated by commas: a point on the plane,
/// the plane's normal toward the viewer, and the picture's up direction. If the last three numbers are
/// missing, up is `scene_up`, or any direction if `scene_up` is along the normal. Throws Error(usage).
PicturePlane parse_plane(const std::string& text, const Eigen::Vector3d& scene_up);

/// The rectangle of the plane covered by the model's bounds.
Eigen::AlignedBox2d extent_on(const PicturePlane& plane, const package::SceneRecord& scene);
/// "LEFT,BOTTOM,RIGHT,TOP". Throws Error(usage).
Eigen::AlignedBox2d parse_extent(const std::string& text);

/// Parses a plane that cuts the model: a point in input coordinates, and the normal toward the removed part,
/// six numbers separated by commas. `origin`: the package's. Throws Error(usage).
SectionPlane parse_section(const std::string& text, const Eigen::Vector3d& origin);
/// The inverse of parse_section().
std::string section_text(const SectionPlane& section, const Eigen::Vector3d& origin);

/// The six lines of a world file (ESRI), which map columns and rows of a picture to x and y of the plane: the
/// steps per pixel and the center of the upper left pixel.
std::string world_file_text(const Eigen::Vector2d& upper_left, double resolution);

}  // namespace vantage
