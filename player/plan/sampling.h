#pragma once
#include <Eigen/Core>
#include <optional>

#include "player/view.h"
#include "scene/package_format.h"

namespace vantage {

/// A point of a surface, relative to the origin, and the steps on the plane there from one sample of a view's
/// picture to the next along its sides.
struct SurfaceSample {
    Eigen::Vector3d position, along_x, along_y;
    double coarser = 0;  ///< levels that need not be there, because the photo counts for little
};
/// `samples` along a pixel's side. Empty where the point is behind the viewer or its plane is seen edge-on.
std::optional<SurfaceSample> surface_sample(const View& view, const Eigen::Vector3d& position,
                                            const Eigen::Vector3d& normal, double samples);

/// log2 of photo pixels from a sample to the next, along the shorter step but at most 4 times the longer's,
/// as footprint_of() in shaders/blend.frag; for a point before the photo.
double level_of_detail(const SurfaceSample& sample, const Intrinsics& photo, const Pose& photo_from_origin);

/// Levels of detail between which a surface's samples lie: 0 is one photo pixel a sample, each further one
/// twice as many along a side.
struct LevelRange {
    double finest, coarsest;
};

/// The levels that shaders/blend.frag computes for fragments of a cluster: from the cluster's sphere and the
/// normals its cone holds, but no finer than a surface slanted by 60 degrees in the photo asks for. `samples`
/// a pixel's side.
LevelRange sampled_levels(const package::ClusterRecord& cluster, const Intrinsics& photo,
                          const Pose& photo_from_origin, const View& view, double samples);

}  // namespace vantage
