#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace vantage {

/// Signed distances, in texels, from the center of each texel to the nearest outline of the shapes in a
/// picture: positive inside; between -`most` and `most`. `coverage`: rows of `width` texels, 255: the texel
/// is entirely inside. Edges are located with subtexel accuracy: to a few hundredths of a texel for outlines
/// that are straight over three texels.
std::vector<float> outline_distances(std::span<const std::uint8_t> coverage, int width, int height,
                                     float most);

}  // namespace vantage
