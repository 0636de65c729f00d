#pragma once
#include <string>
#include <vector>

#include "pipeline/costs/costs.h"

namespace vantage {

/// Recommended settings for three purposes, chosen from the trials of a scan. The costs of the combined
/// settings are not filled in, because they must be measured. `input`: the scan or package as named in the
/// commands.
std::vector<Recipe> recipes(const ScanCosts& costs, const std::string& input);

}  // namespace vantage
