#pragma once
#include "pipeline/stages/stage_input.h"

namespace vantage {

/// The coverage stage: writes a photo's coverage of the model, per cluster (COVR) and per triangle (VISB),
/// computed from the photo's triangle map and texture coordinates.
void make_coverage(StageInput& in);

}  // namespace vantage
