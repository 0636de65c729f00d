#pragma once
#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "player/survey/measurement.h"
#include "player/survey/units.h"
#include "scene/package_format.h"

namespace vantage {

/// The measurements of a scene and what they are stated in.
struct Survey {
    Scale scale{};
    Eigen::Vector3d up = Eigen::Vector3d::UnitZ();  ///< of length 1, in the input's coordinates
    std::vector<Measurement> measurements{};
};

/// The axis of the input's coordinates that is up, if the photos' mean up direction is within 10 degrees of
/// one: photos are rarely held level on average. Otherwise that mean.
Eigen::Vector3d survey_up(std::span<const package::PhotoRecord> photos);

/// "+z", or the direction's three numbers.
std::string direction_text(const Eigen::Vector3d& direction);

/// A table with a line per measurement; numbers in full precision, lengths in the shown unit, coordinates as
/// in the input.
std::string survey_csv(const Survey& survey);

}  // namespace vantage
