#pragma once
#include <Eigen/Core>
#include <string>

#include "player/camera/view.h"
#include "player/survey/measurement.h"

namespace vantage {

/// How a measurement is drawn.
enum class MeasureLook { finished, selected, unfinished };

/// Draws a measurement over the picture, whatever is in front of it: its points, its lines and a label.
/// `origin`: of the view's coordinates, in those of the points; `up` as for evaluate().
void draw_measurement(const Measurement& measurement, const std::string& label, const View& view,
                      const Eigen::Vector3d& origin, const Eigen::Vector3d& up, MeasureLook look);

}  // namespace vantage
