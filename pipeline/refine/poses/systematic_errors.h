#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "pipeline/refine/poses/cell_displacements.h"
#include "pipeline/refine/poses/pose_refinement.h"

namespace vantage {

/// An error of a lens that poses would hide.
struct LensError {
    std::vector<std::uint32_t> photos;  ///< taken with it
    double focal = 0;                   ///< ratio of true to given focal length, minus 1; 0: no error found
    Eigen::Vector2d rows{0, 0};  ///< px to the right and down, from the first row to the last; 0: none found
    std::string words{};         ///< empty: no error found
};

/// Errors that many pairs of photos show in the same way.
struct SystematicErrors {
    std::vector<LensError> lenses;  ///< only those found
    /// The smallest motion that makes the cameras, composed with it, fit the mesh. Identity: no error found.
    Similarity common{};
    double common_motion = 0;  ///< the common motion in px, median
    double uncertainty = 0;    ///< its standard error, px
    std::string words{};       ///< describes the common motion
};

/// Fits, robustly and jointly, a motion of all cameras and, per lens, the focal length and a rolling shutter
/// to the displacements of the pairs' cells. An error is found if its displacement is at least three times
/// its standard error (jackknife over photos) and at least 1 px (a lens), or 0.5 px between photos (all
/// cameras); if it reduces the displacement of held-out cells; and, for lenses, if poses alone do not explain
/// the displacements better. A displaced mesh appears as a motion of all cameras; other errors of the mesh
/// cannot be explained by few parameters.
SystematicErrors systematic_errors(const PoseRefinementInput& in, const CellDisplacements& cells);

/// The displacement of cells if the cameras of `photos` move individually: the median without the motions and
/// with them, in px, over pairs with one of the photos. Half of the cells, as on a checkerboard, are held out
/// of the fit, one half after the other. Both values are 0 without cells.
struct LeftByPoses {
    double before, after;
};
LeftByPoses left_by_poses(const PoseRefinementInput& in, const CellDisplacements& cells,
                          std::span<const std::uint32_t> photos);

}  // namespace vantage
