#pragma once
#include <cstdint>
#include <vector>

#include "pipeline/stages/stage_input.h"

namespace vantage {

/// RGBA8 masks at `mask_level`: angle, depth, border, transient masking; all 0 if the photo does not see the
/// model there. Depth: 255 + 12 log2(density / reference_density), clamped to [1, 255], with density = focal
/// / z in pixels per unit; its square is the sampling rate of [C], and the logarithm keeps a distant photo
/// from becoming 0. Transient masking: 255, as no photos have been compared yet.
std::vector<std::uint8_t> combine_masks(const std::vector<float>& z, const std::vector<std::uint8_t>& angle,
                                        const std::vector<std::uint8_t>& border, double focal,
                                        double reference_density);

/// Masks and depth at one level.
struct MaskLevel {
    int width = 0, height = 0;
    std::vector<std::uint8_t> masks;  ///< RGBA8
    std::vector<float> z;
};

/// The next coarser level. Masks are the mean of the valid texels among 2x2; depth is the farthest finite
/// one, so that what any of them sees stays seen. Odd edges repeat the last texel.
MaskLevel halve(const MaskLevel& level);

/// The stage of masks: writes the levels of masks and depth.
void make_masks(StageInput& in);

}  // namespace vantage
