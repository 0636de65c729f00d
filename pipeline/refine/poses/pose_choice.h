#pragma once
#include <string>

#include "pipeline/refine/poses/pose_rounds.h"
#include "pipeline/refine/poses/systematic_errors.h"

namespace vantage {

/// Decides which cameras move, given that the photos disagree according to `out.decision`. First, the cameras
/// of photos that disagree with all others move, while the others stay. If the others still disagree, all
/// cameras move, unless a systematic error explains the disagreement, because new poses would hide it. New
/// poses are kept only under three conditions. They must halve the displacement of held-out corners. Errors
/// in the mesh also displace corners, but moving cameras hardly reduces these displacements. Held-out photos
/// must be predicted better (see is_called_for), and not worse from their given cameras. Finally, each camera
/// must move by more than its uncertainty. The second condition (prediction) is skipped if the choice is
/// forced or `input.validate` is false. Throws Error(damaged).
void choose_poses(const PoseRefinementInput& input, const CellDisplacements& cells,
                  const SystematicErrors& errors, PoseRefinement& out);

}  // namespace vantage
