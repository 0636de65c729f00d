#pragma once
#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "pipeline/refine/poses/surface_matches.h"
#include "scene/camera/camera.h"

namespace vantage {

/// A camera whose pose is fitted.
struct FittedCamera {
    Intrinsics k;         ///< of the full-size photo
    Pose given;           ///< the scene's pose, toward which the anchor pulls the camera
    double distance = 1;  ///< median depth of the visible surface; scales translation to pixels
    bool fixed = false;   ///< keeps its pose
};

/// Six parameters per camera, in pixels: the rotation about its own axes (rad) times the focal length, and
/// the translation in camera space times the focal length divided by the distance.
using PoseChange = std::array<double, 6>;
/// The camera's given pose with the change applied.
Pose apply_change(const FittedCamera& camera, const PoseChange& change);

/// Result of fit_poses.
struct PoseFit {
    double before = 0, after = 0;  ///< cost
    bool usable = false;           ///< false if there are no residuals or the solver failed
};
/// Bundle adjustment of poses with surface points that slide in their tangent planes. Minimizes the
/// reprojection errors (Cauchy loss at 1 px) plus an anchor prior that pulls each of the six parameters to
/// zero with the weight of `anchor` observations of standard deviation `sigma` px. Ceres solves this with the
/// Schur complement over the points. `change` holds the initial values and receives the result; it is
/// unchanged if the solver finds nothing better.
PoseFit fit_poses(std::span<const FittedCamera> cameras, std::span<const Track> tracks, double anchor,
                  double sigma, std::vector<PoseChange>& change);

}  // namespace vantage
