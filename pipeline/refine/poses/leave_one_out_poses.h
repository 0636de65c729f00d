#pragma once
#include <vector>

#include "pipeline/refine/folds.h"
#include "pipeline/refine/poses/pose_rounds.h"

namespace vantage {

/// For each photo with pixels, the poses of moved cameras, fitted again without the photo's matches: up to
/// package::poses_without_photo cameras that share the most surface with it; other cameras stay. Sorted by
/// the photo, then by the camera. The matches are those found under the solution's poses.
std::vector<LeaveOneOutPose> leave_one_out_poses(const PoseRounds& rounds, const PoseSolution& solution,
                                                 const Folds& folds);

}  // namespace vantage
