#pragma once
#include "pipeline/synth/building.h"

namespace vantage {

/// Adds a glass case around the object to the model: four walls and a lid, greenish, with the alpha of the
/// specification. All other vertices become white and opaque. Photos are rendered without it, as if through
/// clear glass. Does nothing if there is no case.
void add_glass_case(const SynthSpec& spec, SynthModel& model);

}  // namespace vantage
