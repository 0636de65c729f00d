#pragma once
#include "player/options/show_options.h"
#include "scene/package_reader.h"

namespace vantage {

/// Renders the pictures that the options ask for, without a display. Returns the exit code: damaged if a
/// tile's checksum mismatched and a coarser one was shown. Throws Error.
int run_offscreen(const PackageReader& package, const ShowOptions& options);

}  // namespace vantage
