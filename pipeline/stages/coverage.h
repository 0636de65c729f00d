#pragma once
#include "pipeline/stages/stage_input.h"

namespace vantage {

/// The stage of coverage: writes what a photo sees of the model, per cluster (COVR) and per triangle (VISB),
/// by its triangle map and its texture coordinates.
void make_coverage(StageInput& in);

}  // namespace vantage
