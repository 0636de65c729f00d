#pragma once
#include "pipeline/synth/model_builder.h"

namespace vantage {

/// A chapel with a carved portal, two windows and a rose window in its gable, which faces -y at y = 0; in
/// front of it a paved court at z = 0 with an urn on a pedestal, to the left of the center.
void add_chapel(ModelBuilder& b, const SynthSpec& spec);

}  // namespace vantage
