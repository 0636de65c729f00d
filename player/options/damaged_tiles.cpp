#include "player/options/damaged_tiles.h"

#include <cstdio>

#include "base/text/error.h"

namespace vantage {

int exit_for_damaged_tiles(const PackageReader& package, std::size_t damaged) {
    if (!damaged) return int(Exit::ok);
    std::fprintf(stderr,
                 "vantage-player: %s: %zu tiles have a checksum mismatch and were not shown (see vantage "
                 "check --deep)\n",
                 package.path().c_str(), damaged);
    return int(Exit::damaged);
}

}  // namespace vantage
