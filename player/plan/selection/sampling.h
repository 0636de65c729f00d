#pragma once
#include <Eigen/Core>
#include <optional>

#include "player/view/view.h"
#include "scene/package/package_format.h"

namespace vantage {

/// A point on a surface, relative to the origin, and the steps on its tangent plane from one sample of a
/// view's picture to the next, along the picture's rows and columns.
struct SurfaceSample {
    Eigen::Vector3d position, along_x, along_y;
};
/// `samples`: per side of a pixel. Empty if the point is behind the viewer or its plane is seen edge-on.
std::optional<SurfaceSample> surface_sample(const View& view, const Eigen::Vector3d& position,
                                            const Eigen::Vector3d& normal, double samples);

/// log2 of the number of photo pixels from one sample to the next. Uses the shorter step, but at least a
/// quarter of the longer step, as in footprint_of() in shaders/blend.frag. The point must be in front of the
/// photo's camera.
double level_of_detail(const SurfaceSample& sample, const Intrinsics& photo, const Pose& photo_from_origin);

/// The range of levels of detail of a surface's samples: level 0 is one photo pixel per sample, and each
/// further level doubles the number of pixels per side.
struct LevelRange {
    double finest, coarsest;
};

/// The levels computed by shaders/blend.frag for fragments of a cluster, from its bounding sphere and normal
/// cone, but no finer than for a surface tilted by 60 degrees in the photo. `samples`: per side of a pixel.
LevelRange sampled_levels(const package::ClusterRecord& cluster, const Intrinsics& photo,
                          const Pose& photo_from_origin, const View& view, double samples);

}  // namespace vantage
