#pragma once
#include <CLI/CLI.hpp>

#include "player/render/render_settings.h"

namespace vantage {

/// How a package's point cloud is shown.
void add_point_options(CLI::App& app, PointSettings& points);

}  // namespace vantage
