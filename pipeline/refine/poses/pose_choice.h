#pragma once
#include <string>

#include "pipeline/refine/poses/pose_rounds.h"
#include "pipeline/refine/poses/systematic_errors.h"

namespace vantage {

/// Decides which cameras move; `out.decision` says that photos disagree. First the photos that disagree with
/// all others, which stay. Then, if the others still disagree, all, unless a systematic error explains it,
/// which poses would hide. Poses are kept only if they halve the displacement of holdout corners, because
/// errors of the mesh displace corners, too, and moving cameras hardly helps; if held-out photos are
/// predicted better (see is_called_for), and not worse from their given cameras; and, per camera, if it moves
/// by more than its uncertainty. The second condition is skipped if the choice is forced or `input.judge` is
/// false. Throws Error(damaged).
void choose_poses(const PoseRefinementInput& input, const CellDisplacements& cells,
                  const SystematicErrors& errors, PoseRefinement& out);

}  // namespace vantage
