#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "scene/package/package_format.h"

namespace vantage {

/// All photos in their order around the axis `up` through the model's middle: each next one stands to the
/// right of the one before, for somebody who looks at the model. Photos on the axis come as in the file.
std::vector<std::uint32_t> photos_around(std::span<const package::PhotoRecord> photos,
                                         const Eigen::Vector3d& up);

}  // namespace vantage
