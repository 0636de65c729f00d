#pragma once
#include <Eigen/Core>

#include "scene/camera/similarity.h"

namespace vantage {

/// The placement of an object in a scene with several objects. The scene's coordinates are those of the first
/// object. The object is rotated and scaled about the center of its bounds, then translated.
struct Placement {
    Eigen::Vector3d move = Eigen::Vector3d::Zero();  ///< in input units of the first object
    Eigen::Vector3d turn = Eigen::Vector3d::Zero();  ///< degrees about x, then y, then z
    double scale = 1;                                ///< positive
    bool operator==(const Placement&) const = default;
};

/// The rotation that `turn` describes.
Eigen::Matrix3d rotation_of(const Placement& placement);

/// The placement that is equivalent to `matrix`, which transforms the object's own coordinates into the
/// scene's. `middle`: the center of the object's bounds, in its own coordinates.
Placement placement_of(const Similarity& matrix, const Eigen::Vector3d& middle);

}  // namespace vantage
