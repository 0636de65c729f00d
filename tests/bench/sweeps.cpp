#include "tests/bench/sweep.h"

namespace vantage::bench {

// One file in sweeps/ each.
extern const Sweep border_sweep;
extern const Sweep depth_sweep;
extern const Sweep coordinates_sweep;
extern const Sweep undistortion_sweep;
extern const Sweep tile_format_sweep;

std::span<const Sweep> sweeps() {
    static const Sweep all[] = {border_sweep, depth_sweep, coordinates_sweep, undistortion_sweep,
                                tile_format_sweep};
    return all;
}

}  // namespace vantage::bench
