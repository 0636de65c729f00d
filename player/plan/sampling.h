#pragma once
#include <Eigen/Core>
#include <span>

#include "player/view.h"
#include "scene/package_format.h"

namespace vantage {

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

/// log2 of photo pixels a sample, along the shorter side of its footprint but at most 4 times the longer's;
/// at a point in the view's camera on a plane with this normal. Infinite where the plane shows its edge.
double level_of_detail(const Eigen::Vector3d& in_view, const Eigen::Vector3d& normal_in_view,
                       const Eigen::Vector3d& in_photo, const Eigen::Matrix3d& photo_from_view,
                       const Intrinsics& photo, const Intrinsics& view);

}  // namespace vantage
