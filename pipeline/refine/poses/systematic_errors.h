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
    double focal = 0;                   ///< true over given focal length, minus 1; 0: no error found
    Eigen::Vector2d rows{0, 0};  ///< px to the right and down, from the first row to the last; 0: none found
    std::string words{};         ///< empty: no error found
};

/// Errors that many pairs of photos show in the same way.
struct SystematicErrors {
    std::vector<LensError> lenses;  ///< only those found
    /// The smallest motion with which the cameras, composed with it, fit the mesh. Identity: no error found.
    Similarity common{};
    double common_motion = 0;  ///< the same in px, median
    double uncertainty = 0;    ///< standard error of it, px
    std::string words{};       ///< about the common motion
};

/// Fits, robustly and all together, a motion of all cameras and, per lens, the focal length and a rolling
/// shutter to the displacements of the pairs' cells. An error is found if it displaces by three times its
/// standard error (jackknife over photos) and by 1 px (a lens) or photos by 0.5 px from each other (all
/// cameras); if cells that were held out of the fit are displaced less with it; and, for lenses, if poses
/// alone do not explain them better. A displaced mesh shows as a motion of all cameras; other errors of the
/// mesh are not explained by few numbers.
SystematicErrors systematic_errors(const PoseRefinementInput& in, const CellDisplacements& cells);

/// What remains of the displacement of cells if the cameras of `photos` move each on its own: their median
/// without the motions and with them, in px, of pairs with one of the photos; half of the cells, as on a
/// checkerboard, is held out of the fit, one half after the other. 0, 0 without cells.
struct LeftByPoses {
    double before, after;
};
LeftByPoses left_by_poses(const PoseRefinementInput& in, const CellDisplacements& cells,
                          std::span<const std::uint32_t> photos);

}  // namespace vantage
