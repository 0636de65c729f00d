#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "scene/package/package_format.h"

namespace vantage {

/// All photos, ordered around the axis `up` through the model's center: each photo is to the right of the
/// previous one for somebody who faces the model. Photos on the axis are in the order of the file.
std::vector<std::uint32_t> photos_around(std::span<const package::PhotoRecord> photos,
                                         const Eigen::Vector3d& up);

}  // namespace vantage
