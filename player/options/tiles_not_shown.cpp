#include "player/options/tiles_not_shown.h"

#include <algorithm>
#include <cstdio>

#include "base/text/error.h"

namespace vantage {

void TilesNotShown::add(const FrameReport& picture) {
    damaged = std::max(damaged, picture.tiles_damaged);
    too_many =
        std::max(too_many, picture.tiles_missing - std::min(picture.tiles_missing, picture.tiles_damaged));
}

int exit_for(const PackageReader& package, const TilesNotShown& tiles) {
    if (tiles.damaged) {
        std::fprintf(stderr,
                     "vantage-player: %s: %zu tiles have a checksum mismatch and were not shown (see vantage "
                     "check --deep)\n",
                     package.path().c_str(), tiles.damaged);
        return int(Exit::damaged);
    }
    if (!tiles.too_many) return int(Exit::ok);
    std::fprintf(stderr,
                 "vantage-player: %s: %zu tiles do not fit into graphics memory; coarser ones are shown (see "
                 "--graphics-memory)\n",
                 package.path().c_str(), tiles.too_many);
    return int(Exit::incomplete);
}

}  // namespace vantage
