#pragma once
#include "pipeline/synth/model_builder.h"

namespace vantage {

/// A lawn at z = -0.03 around the origin, and a wooded hill around it; clouds in the sky.
void add_garden(ModelBuilder& b, const SynthSpec::Garden& garden);

/// Content of a synthetic scene's photos: the model and, if there is a garden, additional geometry that the
/// model lacks: a lawn at z = -0.03 around it, a wooded hill around the lawn, railings in front of the upper
/// windows, and clouds. Around a chapel: open country, daylight and haze.
SynthModel build_world(const SynthSpec& spec);

}  // namespace vantage
