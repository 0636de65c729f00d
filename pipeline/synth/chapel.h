#pragma once
#include "pipeline/synth/model_builder.h"

namespace vantage {

/// A chapel with a carved portal, two windows and a rose in its gable, which faces -y at y = 0; in front of
/// it a paved court at z = 0 and, left of its middle, an urn on a pedestal.
void add_chapel(ModelBuilder& b, const SynthSpec& spec);

}  // namespace vantage
