#pragma once
#include "pipeline/stages/stage_input.h"

namespace vantage {

/// The stage of coverage: writes a photo's coverage of the model, per cluster (COVR) and per triangle (VISB),
/// from its triangle map and its texture coordinates.
void make_coverage(StageInput& in);

}  // namespace vantage
