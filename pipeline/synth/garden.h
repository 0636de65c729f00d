#pragma once
#include "pipeline/synth/building.h"

namespace vantage {

/// What the photos of a synthetic scene show: the model and, if there is a garden, what the model lacks: a
/// lawn at z = -0.03 around it, a wooded hill around the lawn, railings in front of the upper windows, and
/// clouds.
SynthModel build_world(const SynthSpec& spec);

}  // namespace vantage
