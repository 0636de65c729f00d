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
    Eigen::Vector3d ray;    ///< of photo a, unit length
    double across, along;   ///< standard error across and along the ray, scene units
};

/// Triangulates features that agree with the cameras. Features whose rays do not meet in front of both
/// cameras at an angle of at least 2 degrees yield no point. `pixel`: standard error of a feature, px.
/// `cameras`: one per photo.
std::vector<FeaturePoint> feature_points(std::span<const SharedFeature> features,
                                         std::span<const Camera> cameras, double pixel);

}  // namespace vantage
