#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "pipeline/run/until_stopped.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// Joins the shards that `prepare` made from one scene (PrepareRun::share) into a package that is
/// byte-for-byte identical to the one that a single run writes. An interrupted merge is resumed. Throws
/// Error(input) unless each shard is given exactly once and all have the same inputs and settings. Throws
/// Error(damaged) if a shard is damaged.
void merge(const std::vector<std::filesystem::path>& shares, const std::filesystem::path& out,
           const OnProgress& progress = {});

/// Copies the parts of one scene into one package, whose META and scene record are `meta` and `scene`, and
/// recomputes the results that depend on all photos. Throws Error(damaged) if a part is damaged.
void join(std::span<const PackageReader> parts, const std::string& meta, const package::SceneRecord& scene,
          const std::filesystem::path& out, const OnProgress& progress = {});

}  // namespace vantage
