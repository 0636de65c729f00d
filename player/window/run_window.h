#pragma once
#include "player/options/show_options.h"
#include "scene/package_reader.h"

namespace vantage {

/// Shows the package in a window until it is closed. Returns the exit code: damaged if a damaged tile was
/// found. Throws Error(graphics) without a display or OpenGL 4.5.
int run_window(const PackageReader& package, const ShowOptions& options);

}  // namespace vantage
