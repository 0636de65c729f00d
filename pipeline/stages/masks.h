#pragma once
#include <cstdint>
#include <vector>

namespace vantage {

/// RGBA8 masks at `mask_level`: angle, depth, border, consensus (255 where the photo sees the model: no photo
/// has been compared yet).
/// Depth channel: 255 + 12 log2(density / reference), at least 1, where density = f / z in pixels per unit;
/// its square is the sampling rate of Callieri et al. 2008, and the logarithm keeps a far photo from becoming
/// zero.
std::vector<std::uint8_t> combine_masks(const std::vector<float>& z, const std::vector<std::uint8_t>& angle,
                                        const std::vector<std::uint8_t>& border, double focal,
                                        double reference_density);

/// Masks and depth at one level.
struct MaskLevel {
    int width = 0, height = 0;
    std::vector<std::uint8_t> masks;  ///< RGBA8
    std::vector<float> z;
};

/// The next coarser level: masks are the mean of the valid ones among 2x2, depth is the farthest finite one
/// (so that what any of them sees stays seen); odd edges repeat their last texel.
MaskLevel halve(const MaskLevel& level);

}  // namespace vantage
