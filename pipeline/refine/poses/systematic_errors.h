#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "pipeline/refine/poses/cell_displacements.h"
#include "pipeline/refine/poses/pose_refinement.h"

namespace vantage {

/// A lens error that new poses would hide.
struct LensError {
    std::vector<std::uint32_t> photos;  ///< taken with this lens
    double focal = 0;                   ///< ratio of true to given focal length, minus 1; 0: no error found
    Eigen::Vector2d rows{0, 0};         ///< displacement from the first row to the last, px; 0: none found
    std::string words{};                ///< empty: no error found
};

/// Errors that show in the same way in many pairs of photos.
struct SystematicErrors {
    std::vector<LensError> lenses;  ///< only lenses with an error
    /// The smallest motion that makes the cameras fit the mesh when each camera is composed with it. It is
    /// the identity if no error was found.
    Similarity common{};
    double common_motion = 0;  ///< median of the common motion, px
    double uncertainty = 0;    ///< standard error of the common motion, px
    std::string words{};       ///< describes the common motion
};

/// Fits a motion of all cameras and, for each lens, the focal length and a rolling shutter to the
/// displacements of the pairs' cells, robustly and jointly. An error counts as found only if its displacement
/// is at least three times its standard error (jackknife over photos) and at least 1 px for a lens, or 0.5 px
/// between photos for all cameras. It must also reduce the displacement of held-out cells, and for a lens,
/// poses alone must not explain the displacements better. A displaced mesh appears as a motion of all
/// cameras; other errors in the mesh cannot be explained by a few parameters.
SystematicErrors systematic_errors(const PoseRefinementInput& in, const CellDisplacements& cells);

/// The median displacement of cells, in px, before and after the cameras of `photos` move individually, over
/// the pairs that contain one of these photos. The cells are divided like the squares of a checkerboard: one
/// half and then the other is held out of the fit. Both values are 0 if there are no cells.
struct LeftByPoses {
    double before, after;
};
LeftByPoses left_by_poses(const PoseRefinementInput& in, const CellDisplacements& cells,
                          std::span<const std::uint32_t> photos);

}  // namespace vantage
