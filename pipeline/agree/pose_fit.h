#pragma once
#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "pipeline/agree/surface_matches.h"
#include "scene/camera.h"

namespace vantage {

/// A camera whose pose is to be fitted.
struct FittedCamera {
    Intrinsics k;         ///< of the full-size photo
    Pose given;           ///< what the scene came with: the anchor
    double distance = 1;  ///< to what it sees: a move is worth as many pixels as the turn that looks alike
    bool fixed = false;
};

/// Six numbers a camera, in pixels: turns about its own axes times the focal length, and moves times focal
/// length over distance.
using PoseChange = std::array<double, 6>;
Pose changed(const FittedCamera& camera, const PoseChange& change);

/// Moves the cameras so that tracks' points, which may slide on the surface but not leave it, lie where the
/// photos show them: sum over observations of Cauchy(|residual| / 1 px), and an anchor that holds each of the
/// six numbers to zero as if it had been seen so, `anchor` observations strong, each `sigma` pixels good.
/// `change` is where to begin, and the result; it is left as it was where the solver finds nothing better.
/// Ceres, Schur complement over the points. Returns the cost before and after.
struct PoseFit {
    double before = 0, after = 0;
    bool usable = false;
};
PoseFit fit_poses(std::span<const FittedCamera> cameras, std::span<const Track> tracks, double anchor,
                  double sigma, std::vector<PoseChange>& change);

}  // namespace vantage
