#pragma once
#include <vector>

#include "pipeline/refine/folds.h"
#include "pipeline/refine/poses/pose_rounds.h"

namespace vantage {

/// For each photo with pixels, poses of moved cameras that are fitted again without the photo's matches. At
/// most package::poses_without_photo cameras are fitted: those whose photos have the most surface in common
/// with the photo. The other cameras stay. The result is sorted by photo, then by camera. The matches are
/// those found with the solution's poses.
std::vector<LeaveOneOutPose> leave_one_out_poses(const PoseRounds& rounds, const PoseSolution& solution,
                                                 const Folds& folds);

}  // namespace vantage
