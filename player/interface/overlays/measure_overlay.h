#pragma once
#include <Eigen/Core>
#include <string>
#include <utility>
#include <vector>

#include "player/interface/sections/controls.h"
#include "player/survey/measurement.h"
#include "player/survey/scale_bar.h"
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

/// Draws a measurement over the picture, without occlusion: its points, its lines and a label. `origin`: the
/// origin of the view's coordinates, in the coordinates of the points. `up`: as for evaluate().
void draw_measurement(const Measurement& measurement, const std::string& label, const View& view,
                      const Eigen::Vector3d& origin, const Eigen::Vector3d& up, MeasureLook look);

/// Draws a scale bar with this label in the lower right corner of an area.
void draw_scale_bar(Controls& controls, const ScaleBar& bar, const std::string& label, const Area& area);

}  // namespace vantage
