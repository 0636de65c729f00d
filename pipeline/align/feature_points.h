#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "pipeline/align/shared_features.h"
#include "scene/camera/camera.h"

namespace vantage {

/// The triangulated point of a feature.
struct FeaturePoint {
    std::size_t feature;    ///< index of the feature
    Eigen::Vector3d point;  ///< midway between the two rays at their closest approach
    Eigen::Vector3d ray;    ///< direction of photo a's ray, unit length
    double across, along;   ///< standard errors across and along the ray, in scene units
};

/// Triangulates features that agree with the cameras. Features whose rays do not meet in front of both
/// cameras at an angle of at least 2 degrees yield no point. `cameras` has one camera per photo, and `pixel`
/// is the standard error of a feature in px.
std::vector<FeaturePoint> feature_points(std::span<const SharedFeature> features,
                                         std::span<const Camera> cameras, double pixel);

}  // namespace vantage
