#pragma once
#include "pipeline/synth/material.h"

namespace vantage {

/// A point of a surface, as a pixel sees it. Lengths in meters.
struct SurfacePoint {
    Eigen::Vector3d position, normal;
    Eigen::Vector3d toward;  ///< of length 1, in the surface: the direction of the slope
    double footprint;        ///< of the pixel
    double sky;              ///< share of the sky that is seen: dirt gathers where it is small
};

/// Of a weathered surface.
struct Finish {
    Eigen::Vector3f albedo;  ///< linear RGB, [0, 1]
    double slope;            ///< of the relief that the mesh lacks, along `toward`
};

/// For the materials of the chapel and its country, from ashlar on. Detail goes down to the footprint, and
/// no further.
Finish finish(Material material, const SurfacePoint& at);

}  // namespace vantage
