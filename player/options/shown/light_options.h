#pragma once
#include <vector>

#include "player/render/render_settings.h"

namespace vantage {

class Command;

/// Light on the geometry.
struct LightOptions {
    std::vector<double> lamp;  ///< azimuth and elevation, or empty
    LightSettings shown;
};
void add_light_options(const Command& command, LightOptions& options);

/// Throws Error(usage) for an elevation out of range.
LightSettings light_settings(const LightOptions& options);

}  // namespace vantage
