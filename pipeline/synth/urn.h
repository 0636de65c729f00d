#pragma once
#include "pipeline/synth/model_builder.h"

namespace vantage {

/// Adds a marble urn, `height` meters high, with gadroons, garlands and two handles. It stands on `foot` and
/// has approximately `triangles` triangles.
void add_urn(ModelBuilder& b, const Eigen::Vector3d& foot, double height, int triangles);

}  // namespace vantage
