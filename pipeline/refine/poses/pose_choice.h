#pragma once
#include <string>

#include "pipeline/refine/poses/pose_rounds.h"
#include "pipeline/refine/poses/systematic_errors.h"

namespace vantage {

/// Decides which cameras move, given that photos disagree by `out.decision`. First moves the photos that
/// disagree with all others, while the others stay. If the others still disagree, moves all, unless the
/// disagreement is explained by a systematic error, which new poses would hide. New poses are kept only if
/// they halve the displacement of held-out corners (errors of the mesh also displace corners, and moving
/// cameras hardly reduces these); if held-out photos are predicted better (see is_called_for), and not worse
/// from their given cameras; and, per camera, if it moves by more than its uncertainty. The second condition
/// (prediction) is skipped if the choice is forced or `input.validate` is false. Throws Error(damaged).
void choose_poses(const PoseRefinementInput& input, const CellDisplacements& cells,
                  const SystematicErrors& errors, PoseRefinement& out);

}  // namespace vantage
