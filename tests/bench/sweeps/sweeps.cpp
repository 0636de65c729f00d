#include "tests/bench/sweeps/sweep.h"

namespace vantage::bench {

// Each sweep has its own file, except for sweeps that share code.
extern const Sweep border_sweep, depth_sweep, coordinates_sweep, tile_format_sweep, tile_size_sweep,
    tile_border_sweep, blending_sweep, exponent_sweep, sums_sweep, selection_sweep, hysteresis_sweep,
    filtering_sweep, loading_sweep, guards_sweep, two_eyes_sweep, second_eye_sweep;

std::span<const Sweep> sweeps() {
    static const Sweep all[] = {border_sweep,    depth_sweep,       coordinates_sweep, tile_format_sweep,
                                tile_size_sweep, tile_border_sweep, blending_sweep,    exponent_sweep,
                                sums_sweep,      selection_sweep,   hysteresis_sweep,  filtering_sweep,
                                loading_sweep,   guards_sweep,      two_eyes_sweep,    second_eye_sweep};
    return all;
}

}  // namespace vantage::bench
