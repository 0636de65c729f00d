#pragma once
#include "pipeline/synth/model_builder.h"

namespace vantage {

/// Open country around the origin, 6 km in radius: a meadow at z = -0.03 that extends to the garden's radius,
/// and beyond it hills that are as high as `garden.hill`.
void add_country(ModelBuilder& b, const SynthSpec::Garden& garden);

}  // namespace vantage
