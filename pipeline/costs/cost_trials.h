#pragma once
#include <vector>

#include "pipeline/costs/costs.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// The trials on a scan: the defaults first, then the settings in order of their importance to most users.
/// `whole`: the scan prepared with the defaults. `prepares`: false if there is only a package, so that only
/// the player's settings can be tried. Throws Error(damaged).
std::vector<CostTrial> cost_trials(const PackageReader& whole, bool prepares);

/// The number of photos blended in the window by default.
inline constexpr const char* window_photos = "4";

}  // namespace vantage
