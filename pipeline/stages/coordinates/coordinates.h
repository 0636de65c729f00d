#pragma once
#include "pipeline/stages/stage_input.h"

namespace vantage {

/// The stage of texture coordinates: writes them, if the package holds any for the photo, and the photo's
/// measurements: the footprint hull, the fraction of visible vertices, depths.
void make_coordinates(StageInput& in);

}  // namespace vantage
