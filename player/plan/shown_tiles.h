#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>

#include "player/plan/tile_needs.h"
#include "player/view.h"

namespace vantage {

/// A point that a view shows, relative to the origin, and the steps on its surface from one sample of the
/// picture to the next along its sides.
struct SurfaceSample {
    Eigen::Vector3d position, along_x, along_y;
    double coarser = 0;  ///< levels that need not be there, because the photo counts for little
};
/// `samples` along a pixel's side. Empty where the point is outside the frame or its surface is seen edge-on.
std::optional<SurfaceSample> surface_sample(const View& view, const Eigen::Vector3d& position,
                                            const Eigen::Vector3d& normal, double samples);

/// Which tiles of one photo are worth having to show these samples, each of which stands for `pixels` samples
/// of the picture: those of whose texels at least the share `worth` would be shown. Where a tile is not, the
/// next coarser one shows its part as well; on the coarsest level every tile is worth it.
TileNeeds shown_tiles(const package::PhotoRecord& photo, const Intrinsics& intrinsics,
                      const Pose& photo_from_origin, std::span<const SurfaceSample> samples, double pixels,
                      double worth);

}  // namespace vantage
