#pragma once
#include <vector>

#include "player/render/render_settings.h"

namespace vantage {

class Command;

/// Lighting of the geometry.
struct LightOptions {
    std::vector<double> lamp;  ///< azimuth and elevation, or empty
    LightSettings shown;
};
void add_light_options(const Command& command, LightOptions& options);

/// Throws Error(usage) for an elevation outside the valid range.
LightSettings light_settings(const LightOptions& options);

}  // namespace vantage
