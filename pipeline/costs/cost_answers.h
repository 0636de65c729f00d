#pragma once
#include <span>
#include <string>
#include <vector>

#include "pipeline/costs/costs.h"

namespace vantage {

/// A sentence each on the settings about which users ask most, on the recommendations, and on how certain the
/// results are. Option names are between backticks.
std::vector<std::string> cost_answers(std::span<const ScanCosts> scans);

/// Whether a trial or a recommendation keeps all defaults.
bool changes_nothing(const CostTrial& trial);

/// "`--max-photo-size 708`", or "the defaults".
std::string settings_in_words(const Recipe& recipe);

/// "353 ms (2.8 per second)"; empty if it was not measured.
std::string frame_in_words(const std::vector<double>& ms);

}  // namespace vantage
