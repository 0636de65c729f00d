#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace vantage {

/// Signed distances, in texels, from the middle of each texel to the nearest outline of the shapes in a
/// picture: above 0 inside; at most `most`, at least -`most`. `coverage`: rows of `width` texels, 255: all of
/// the texel is inside. Edges are found within texels: outlines that are straight over three texels are
/// right to a few hundredths.
std::vector<float> outline_distances(std::span<const std::uint8_t> coverage, int width, int height,
                                     float most);

}  // namespace vantage
