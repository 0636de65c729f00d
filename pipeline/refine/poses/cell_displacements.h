#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/refine/poses/common_motion.h"
#include "pipeline/refine/poses/pose_refinement.h"

namespace vantage {

/// The displacement of the surface in a cell of a pair's first photo, and its derivatives with respect to
/// camera errors. All unknowns are in pixels.
struct CellDisplacement {
    Eigen::Vector2d moved;  ///< px of the first photo
    double weight;          ///< number of matches, at most 4
    bool odd;               ///< true for every other cell, as on a checkerboard
    /// Per pose: rotation about the camera's axes times the focal length, translation times focal length over
    /// distance.
    Eigen::Matrix<double, 2, 6> pose_a, pose_b;
    /// Per lens: a longer focal length, in px at half the diagonal; a displacement to the right and down from
    /// the first row to the last, 0 in the middle.
    Eigen::Matrix<double, 2, 3> lens_a, lens_b;
    /// With respect to a common motion of all cameras: a SmallMotion divided by
    /// `CellDisplacements::frame_unit`.
    Eigen::Matrix<double, 2, 7> frame = Eigen::Matrix<double, 2, 7>::Zero();
    Eigen::Matrix<double, 2, 7> seen =
        Eigen::Matrix<double, 2, 7>::Zero();  ///< motion of the surface in the first photo due to that motion
};

/// The cells of one pair.
struct PairCells {
    std::uint32_t a, b;
    std::vector<CellDisplacement> cells;
};

/// The cells of all trusted pairs that show one smooth surface around their center.
struct CellDisplacements {
    std::vector<PairCells> pairs;
    MotionFrame frame;
    double frame_unit = 0;  ///< scale of a SmallMotion of about one pixel
};
/// Reads the depth of each first photo at a coarse level. Throws Error(damaged).
CellDisplacements cell_displacements(const PoseRefinementInput& in,
                                     std::span<const package::PairRecord> pairs);

}  // namespace vantage
