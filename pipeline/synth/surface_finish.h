#pragma once
#include "pipeline/synth/material.h"

namespace vantage {

/// A surface point in a pixel. Lengths are in meters.
struct SurfacePoint {
    Eigen::Vector3d position, normal;
    Eigen::Vector3d toward;  ///< tangent of length 1: the direction of the slope
    double footprint;        ///< of the pixel
    double sky;              ///< visible fraction of the sky; dirt gathers where this is small
};

/// Appearance of a weathered surface.
struct Finish {
    Eigen::Vector3f albedo;  ///< linear RGB, [0, 1]
    double slope;            ///< slope, along `toward`, of the relief that is not in the mesh
};

/// The finish of the materials of the chapel and of the country around it, that is, of Material::ashlar and
/// those after it. Detail finer than the footprint is omitted.
Finish finish(Material material, const SurfacePoint& at);

}  // namespace vantage
