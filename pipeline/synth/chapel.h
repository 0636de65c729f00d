#pragma once
#include "pipeline/synth/model_builder.h"

namespace vantage {

/// A chapel with a carved portal, two windows and a rose window in its gabled front, which lies at y = 0 and
/// faces -y. In front of it is a paved court at z = 0, with an urn on a pedestal to the left of the center.
void add_chapel(ModelBuilder& b, const SynthSpec& spec);

}  // namespace vantage
