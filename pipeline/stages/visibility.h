#pragma once
#include <Eigen/Core>
#include <span>

#include "pipeline/ray_scene.h"
#include "scene/camera.h"

namespace vantage {

/// What the OpenGL pass writes for a vertex whose visibility the depth map does not settle.
inline constexpr float unsettled_coordinate = -2;

/// Settles the unsettled of a photo's texture coordinates by a ray each: near silhouettes and in folds a
/// depth map, which knows the surface at pixel centres only, is several pixels of depth off. `positions` and
/// the pose are relative to the origin; a vertex becomes its coordinate, or (-1,-1) where something hides it
/// by more than a third of a pixel's footprint.
void settle_visibility(const RayScene& rays, std::span<const Eigen::Vector3f> positions,
                       const Intrinsics& intrinsics, const Pose& cam_from_origin,
                       std::span<Eigen::Vector2f> coordinates);

}  // namespace vantage
