#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/refine/poses/common_motion.h"
#include "pipeline/refine/poses/pose_refinement.h"

namespace vantage {

/// The displacement of the surface in a cell of a pair's first photo, and its derivatives with respect to
/// camera errors. All camera errors are expressed in pixels.
struct CellDisplacement {
    Eigen::Vector2d moved;  ///< in px of the first photo
    double weight;          ///< number of matches, at most 4
    bool odd;               ///< true for every other cell, as on a checkerboard
    /// For each pose: the rotation about the camera's axes times the focal length, and the translation times
    /// the focal length divided by the distance.
    Eigen::Matrix<double, 2, 6> pose_a, pose_b;
    /// For each lens: an increase of the focal length, in px at half the diagonal, and a displacement to the
    /// right and downward that grows from the first row to the last and is 0 in the middle.
    Eigen::Matrix<double, 2, 3> lens_a, lens_b;
    /// For a common motion of all cameras: a SmallMotion divided by `CellDisplacements::frame_unit`.
    Eigen::Matrix<double, 2, 7> frame = Eigen::Matrix<double, 2, 7>::Zero();
    Eigen::Matrix<double, 2, 7> seen =
        Eigen::Matrix<double, 2, 7>::Zero();  ///< resulting motion of the surface in the first photo
};

/// The cells of one pair.
struct PairCells {
    std::uint32_t a, b;
    std::vector<CellDisplacement> cells;
};

/// The cells of all trusted pairs. Only cells with one smooth surface around their center are included.
struct CellDisplacements {
    std::vector<PairCells> pairs;
    MotionFrame frame;
    double frame_unit = 0;  ///< size of a SmallMotion that moves the surface by about one pixel
};
/// Reads the depth of each first photo at a coarse level. Throws Error(damaged).
CellDisplacements cell_displacements(const PoseRefinementInput& in,
                                     std::span<const package::PairRecord> pairs);

}  // namespace vantage
