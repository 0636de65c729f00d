#pragma once
#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "player/survey/measurement.h"
#include "player/survey/units.h"
#include "scene/package/package_format.h"

namespace vantage {

/// The measurements of a scene, and their units.
struct Survey {
    Scale scale{};
    Eigen::Vector3d up = Eigen::Vector3d::UnitZ();  ///< unit vector, in input coordinates
    std::vector<Measurement> measurements{};
    /// Ignores `up`, which follows from the scene.
    bool operator==(const Survey& o) const { return scale == o.scale && measurements == o.measurements; }
};

/// "+z", or the direction's three numbers.
std::string direction_text(const Eigen::Vector3d& direction);

/// A table with one line per measurement. Numbers have full precision, lengths are in the displayed unit, and
/// coordinates are those of the input.
std::string survey_csv(const Survey& survey);

}  // namespace vantage
