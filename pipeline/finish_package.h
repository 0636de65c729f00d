#pragma once
#include <string>

#include "pipeline/prepare_plan.h"
#include "pipeline/refine/refine.h"
#include "scene/package_writer.h"

namespace vantage {

/// Settles what only all photos together tell, their colours, and finishes the package: META, SCEN, PHOT and
/// STAT. `meta` as provenance() has it; every photo's chunks are there. Returns what it found about the
/// colours. Throws Error(storage).
ColorRefinement finish_package(PackageWriter& writer, const std::string& meta, package::SceneRecord scene,
                               PhotoTables& photos);

}  // namespace vantage
