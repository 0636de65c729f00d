#pragma once
#include <string>
#include <vector>

#include "pipeline/input/scene_input.h"
#include "pipeline/settings/settings.h"
#include "scene/package_reader.h"

namespace vantage {

/// One message for each setting that the package was prepared with: its cost and loss compared with other
/// values, as measured by vantage-bench (configs/costs.json). Throws Error(usage) if that file is missing or
/// invalid.
std::vector<std::string> explain(const PrepareSettings& settings, const SceneInput& scene,
                                 const PackageReader& package);

}  // namespace vantage
