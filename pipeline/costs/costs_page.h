#pragma once
#include <string>
#include <vector>

#include "pipeline/costs/costs.h"

namespace vantage {

/// The machine, program and date: "vantage 0.6.1, 2026-11-30, ...".
std::string origin_of(const Costs& costs);

/// A line per scan: photos, sizes, and the defaults' costs.
std::vector<std::string> scans_in_words(const Costs& costs);

/// A line per recommendation: purpose, commands and costs.
std::vector<std::string> recipes_in_words(const ScanCosts& scan);

/// A self-contained HTML page with charts, the table and recommendations.
std::string costs_page(const Costs& costs);

}  // namespace vantage
