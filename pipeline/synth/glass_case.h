#pragma once
#include "pipeline/synth/building.h"

namespace vantage {

/// Adds a greenish glass case around the object: four walls and a lid, with the alpha given in the
/// specification. All other vertices become white and opaque. Photos are rendered without the case, as if
/// through clear glass. Does nothing if the specification has no case.
void add_glass_case(const SynthSpec& spec, SynthModel& model);

}  // namespace vantage
