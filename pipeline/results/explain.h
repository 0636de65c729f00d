#pragma once
#include <string>
#include <vector>

#include "pipeline/input/scene_input.h"
#include "pipeline/settings/settings.h"
#include "scene/package_reader.h"

namespace vantage {

/// For each setting that the package was prepared with, a line for people: what it costs and gives up beside
/// the others, as measured (configs/costs.json, written by vantage-bench). Throws Error(usage) where that
/// file is missing or no such file.
std::vector<std::string> explain(const PrepareSettings& settings, const SceneInput& scene,
                                 const PackageReader& package);

}  // namespace vantage
