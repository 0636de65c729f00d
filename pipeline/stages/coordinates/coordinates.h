#pragma once
#include "pipeline/stages/stage_input.h"

namespace vantage {

/// The texture coordinate stage. It writes the texture coordinates, if the package holds any for the photo,
/// and the photo's measurements: the footprint hull, the fraction of visible vertices and the depths.
void make_coordinates(StageInput& in);

}  // namespace vantage
