#include "player/options/headset_options.h"

#include "cli/real_range.h"

namespace vantage {

void add_headset_options(CLI::App& app, HeadsetOptions& o) {
    const std::string group = "Headset";
    CLI::Option* xr =
        app.add_flag("--xr", o.on,
                     "show the scene in a headset, through the active OpenXR runtime; a window shows what is "
                     "seen there")
            ->group(group);
    app.add_option("--unit-meters", o.unit_meters,
                   "length of a scene unit in meters, so that the scene appears at its own size (default: "
                   "that of the scene's measurements; without any, as large as an object at arm's length)")
        ->check(real_range(1e-9, 1e9))
        ->group(group)
        ->needs(xr);
}

}  // namespace vantage
