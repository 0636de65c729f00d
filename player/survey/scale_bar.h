#pragma once
#include <Eigen/Core>
#include <optional>

#include "player/survey/units.h"
#include "player/view/view.h"

namespace vantage {

/// A bar in the picture that shows a length.
struct ScaleBar {
    double length = 0;  ///< 1, 2 or 5 times a power of ten, in the displayed unit
    double pixels = 0;  ///< the length of the bar
};

/// The scale bar for lengths across the picture, at the depth of a point that is relative to the origin. The
/// bar is at most 1.6 times longer or shorter than `pixels`. Returns nullopt if the unit is unknown or the
/// point is behind the viewer.
std::optional<ScaleBar> scale_bar(const View& view, const Eigen::Vector3d& point, const Scale& scale,
                                  double pixels);

}  // namespace vantage
