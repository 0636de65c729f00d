#pragma once
#include <cstdint>
#include <vector>

#include "pipeline/stages/stage_input.h"

namespace vantage {

/// RGBA8 weight maps at `weight_map_level`: angle, depth, border, transient masking; all 0 if the photo does
/// not see the model there. Depth: 255 + 12 log2(density / reference_density), clamped to [1, 255], with
/// density = focal / z in pixels per unit. The square of the density is the sampling rate of [C]; the
/// logarithm keeps the weight of a distant photo from becoming 0. Transient masking: 255, because no photos
/// have been compared yet.
std::vector<std::uint8_t> combine_weights(const std::vector<float>& z, const std::vector<std::uint8_t>& angle,
                                          const std::vector<std::uint8_t>& border, double focal,
                                          double reference_density);

/// Weight maps and depth at one level.
struct WeightMapLevel {
    int width = 0, height = 0;
    std::vector<std::uint8_t> weights;  ///< RGBA8
    std::vector<float> z;
};

/// The next coarser level. A weight is the mean of the valid texels in a 2x2 block. Depth is the farthest
/// finite depth among them, so that a surface seen by any of the texels stays visible. Odd edges repeat the
/// last texel.
WeightMapLevel halve(const WeightMapLevel& level);

/// The weight map stage: writes the levels of weight maps and depth.
void make_weight_maps(StageInput& in);

}  // namespace vantage
