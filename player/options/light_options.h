#pragma once
#include <CLI/CLI.hpp>
#include <vector>

#include "player/render/render_settings.h"

namespace vantage {

/// Light on the geometry.
struct LightOptions {
    std::vector<double> lamp;  ///< azimuth and elevation, or empty
    LightSettings shown;
};
void add_light_options(CLI::App& app, LightOptions& options);

/// Throws Error(usage) for an elevation out of range.
LightSettings light_settings(const LightOptions& options);

}  // namespace vantage
