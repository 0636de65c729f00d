#pragma once
#include "player/options.h"
#include "scene/package_reader.h"

namespace vantage {

/// Renders the pictures that the options ask for, without a display. Returns the exit code: damaged where a
/// tile's checksum was wrong and a coarser one was shown.
int run_offscreen(const PackageReader& package, const Options& options);

/// All photos that are not excluded. Throws Error(usage) for an unknown name.
std::vector<std::uint32_t> photos_in_use(const PackageReader& package, const Options& options);

/// The options' settings with what depends on the package filled in.
RenderSettings render_settings(const PackageReader& package, const Options& options);

MemoryBudget memory_budget(const Options& options);

}  // namespace vantage
