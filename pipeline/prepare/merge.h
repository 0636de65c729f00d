#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "pipeline/run/progress.h"
#include "scene/package_reader.h"

namespace vantage {

/// Joins the shares that `prepare` made of one scene (PrepareRun::share) into the package that one run gives,
/// byte by byte. What an earlier merge copied already is kept. Throws Error(input) unless every share is
/// there once and all come from the same inputs and settings, Error(damaged) for a share that is not sound.
void merge(const std::vector<std::filesystem::path>& shares, const std::filesystem::path& out,
           const OnProgress& progress = {});

/// Copies what parts of one scene hold into one package, under this META and scene record, and settles anew
/// what only all photos together tell. Throws Error(damaged) for what is not sound.
void join(std::span<const PackageReader> parts, const std::string& meta, const package::SceneRecord& scene,
          const std::filesystem::path& out, const OnProgress& progress = {});

}  // namespace vantage
