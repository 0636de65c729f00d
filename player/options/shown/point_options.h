#pragma once
#include <string>

#include "player/render/render_settings.h"

namespace vantage {

class Command;

/// How a package's point cloud is shown.
struct PointOptions {
    std::string show = "on", size = "1";
    PointColor color = PointColor::automatic;
};
void add_point_options(const Command& command, PointOptions& options);

/// Throws Error(usage) for a size that is none.
PointSettings point_settings(const PointOptions& options);

}  // namespace vantage
