#pragma once
#include <string>

#include "player/render/render_settings.h"

namespace vantage {

class Command;

/// Display of a package's point cloud.
struct PointOptions {
    std::string show = "on", size = "1";
    PointColor color = PointColor::automatic;
};
void add_point_options(const Command& command, PointOptions& options);

/// Throws Error(usage) for an invalid size.
PointSettings point_settings(const PointOptions& options);

}  // namespace vantage
