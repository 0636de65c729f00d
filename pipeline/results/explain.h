#pragma once
#include <string>
#include <vector>

#include "pipeline/input/scene_input.h"
#include "pipeline/settings/settings.h"
#include "scene/package_reader.h"

namespace vantage {

/// For each setting that the package was prepared with, a message: its cost and loss compared with other
/// values, as measured (configs/costs.json, written by vantage-bench). Throws Error(usage) if that file is
/// missing or invalid.
std::vector<std::string> explain(const PrepareSettings& settings, const SceneInput& scene,
                                 const PackageReader& package);

}  // namespace vantage
