#pragma once
#include <Eigen/Geometry>
#include <cstdint>

#include "scene/camera/camera.h"
#include "scene/camera/lens.h"
#include "scene/package/contents/effects.h"
#include "scene/package/package_format.h"

namespace vantage {

class PackageReader;

/// A photo's pinhole camera, for positions relative to the origin.
Intrinsics intrinsics(const package::PhotoRecord& photo);
/// The lens that displaces the photo's pixels relative to that camera. Throws Error(damaged) if the model is
/// unknown or a coefficient is not finite.
Lens lens_of(const PackageReader& package, std::uint32_t photo);
Pose cam_from_origin(const package::PhotoRecord& photo);
Pose cam_from_origin(const package::PoseRefinementRecord& given);
Pose cam_from_origin(const package::LeaveOneOutPoseRecord& without);
/// The bounds of the model without strays, relative to the origin.
Eigen::AlignedBox3d bounds_from_origin(const package::SceneRecord& scene);
/// An upper bound on the distance from the camera to the part of the model within its bounds.
double model_reach(const package::SceneRecord& scene, const Pose& cam_from_origin);
/// The distance from a photo's camera to the surface that the photo sees, or to the origin if it sees none.
/// The distance is always positive.
double seen_distance(const package::PhotoRecord& photo);
/// The up direction, of length 1, without negative zeros.
inline Eigen::Vector3d up_of(const package::SceneRecord& scene) { return Eigen::Array3d(scene.up) + 0.0; }
bool effect_on(const package::SceneRecord& scene, Effect effect);

/// The reason why a record is unusable; null if it is valid.
const char* flaw_of(const package::PhotoRecord& photo);
const char* flaw_of(const package::SceneRecord& scene);

}  // namespace vantage
