#pragma once
#include "pipeline/synth/model_builder.h"

namespace vantage {

/// A marble urn with gadroons, garlands and two handles, `height` meters high, with approximately this many
/// triangles, standing on `foot`.
void add_urn(ModelBuilder& b, const Eigen::Vector3d& foot, double height, int triangles);

}  // namespace vantage
