#include "player/options/headset_options.h"

#include "base/cli/command.h"

namespace vantage {

void add_headset_options(const Command& c, HeadsetOptions& o) {
    c.real("--meters-per-unit", o.unit_meters, 1e-9, 1e9,
           "length of a scene unit in meters, so that the scene appears at its own size (default: that of "
           "the scene's measurements; without any, as large as an object at arm's length)");
}

}  // namespace vantage
