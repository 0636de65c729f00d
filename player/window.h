#pragma once
#include "player/options.h"
#include "scene/package_reader.h"

namespace vantage {

/// Shows the package in a window until it is closed. Throws Error(graphics) where there is no display or no
/// OpenGL 4.5.
int run_window(const PackageReader& package, const Options& options);

}  // namespace vantage
