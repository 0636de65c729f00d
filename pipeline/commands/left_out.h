#pragma once
#include <vector>

#include "pipeline/input/scene_input.h"
#include "scene/error.h"

namespace vantage {

/// Names the photos that a package lacks, a line each on the output, and says whether it is complete.
Exit report_left_out(const std::vector<UnusablePhoto>& left_out);

}  // namespace vantage
