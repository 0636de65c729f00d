#pragma once
#include "pipeline/synth/model_builder.h"

namespace vantage {

/// Open country around the origin, 6 km in radius: a meadow at z = -0.03 as far as the garden's radius, then
/// hills as high as the garden's.
void add_country(ModelBuilder& b, const SynthSpec::Garden& garden);

}  // namespace vantage
