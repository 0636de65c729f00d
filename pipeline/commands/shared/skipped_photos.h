#pragma once
#include <vector>

#include "base/text/error.h"
#include "pipeline/input/scene_input.h"

namespace vantage {

/// Prints the photos that a package lacks, one per line. Returns `incomplete` if there are any, otherwise
/// `ok`.
Exit report_skipped(const std::vector<UnusablePhoto>& skipped);

}  // namespace vantage
