#pragma once
#include <array>
#include <cstdint>

#include "player/plan/plan_scene.h"

namespace vantage {

/// A photo's camera in the scene: its center and the corners of its picture, clockwise from the upper left,
/// relative to the package's origin.
struct PhotoFrustum {
    Eigen::Vector3d center;
    std::array<Eigen::Vector3d, 4> corner;
};

/// The frustum with the picture at a distance of `depth` from the center.
PhotoFrustum photo_frustum(const PlanScene& scene, std::uint32_t photo, double depth);
/// The frustum with the picture at a distance that is proportional to the scene's size.
PhotoFrustum photo_frustum(const PlanScene& scene, std::uint32_t photo);

}  // namespace vantage
