#pragma once
#include <Eigen/Core>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "player/interface/sections/controls.h"
#include "player/survey/measurement.h"
#include "player/survey/units.h"
#include "player/view/view.h"

namespace vantage {

/// Style of a measurement in the picture. `preview`: unfinished, and its last point follows the pointer.
enum class MeasureLook { finished, selected, unfinished, preview };

/// A measurement's points relative to `origin`, which is in the points' coordinates.
std::vector<Eigen::Vector3d> points_from(const Measurement& measurement, const Eigen::Vector3d& origin);
/// The lines of a measurement through these points. `up`: as for evaluate(), in the coordinates of the
/// points.
std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> lines_of(Measure measure,
                                                                  const std::vector<Eigen::Vector3d>& points,
                                                                  const Eigen::Vector3d& up);
/// Position of a measurement's label. The measurement must have at least one point.
Eigen::Vector3d label_place(Measure measure, const std::vector<Eigen::Vector3d>& points,
                            const Eigen::Vector3d& up);

/// A measurement as it is drawn in the picture.
struct DrawnMeasurement {
    Measurement measurement;
    std::string label;
    MeasureLook look;
};

/// Draws measurements over the picture, without occlusion: their points, their lines and labels, which do not
/// cover each other. `origin`: the origin of the view's coordinates, in the coordinates of the points. `up`:
/// as for evaluate().
void draw_measurements(Controls& controls, std::span<const DrawnMeasurement> measurements, const View& view,
                       const Eigen::Vector3d& origin, const Eigen::Vector3d& up);

/// Draws a scale bar for lengths at the depth of `point` in the lower right corner of an area, if the scale
/// is known. `point`: relative to the view's origin.
void show_scale_bar(Controls& controls, const View& view, const Eigen::Vector3d& point, const Scale& scale,
                    const Area& area);

}  // namespace vantage
