#pragma once
#include "pipeline/synth/model_builder.h"

namespace vantage {

/// Adds a lawn at z = -0.03 around the origin, a wooded hill around the lawn, and clouds in the sky.
void add_garden(ModelBuilder& b, const SynthSpec::Garden& garden);

/// The content of a synthetic scene's photos: the model and, if there is a garden, additional geometry that
/// is not in the model: a lawn at z = -0.03, a wooded hill around the lawn, railings in front of the upper
/// windows, and clouds. A chapel is surrounded by open country instead, with daylight and haze.
SynthModel build_world(const SynthSpec& spec);

}  // namespace vantage
