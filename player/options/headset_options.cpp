#include "player/options/headset_options.h"

#include "base/cli/command.h"

namespace vantage {

void add_headset_options(const Command& c, HeadsetOptions& o) {
    c.real("--meters-per-unit", o.unit_meters, 1e-9, 1e9,
           "length of a scene unit in meters, so that the scene appears at its true size (default: from the "
           "scene's measurements; without measurements, the scene appears as large as an object at arm's "
           "length)");
}

}  // namespace vantage
