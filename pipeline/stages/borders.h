#pragma once
#include <cstdint>
#include <vector>

namespace vantage {

/// Linear depth, +inf where nothing is seen, and validity (0 = no photo there; empty = all valid), row by
/// row.
struct DepthMap {
    int width = 0, height = 0;
    std::vector<float> z;
    std::vector<std::uint8_t> valid;
};

/// 1 where the Sobel 3x3 response of depth, relative to depth, exceeds `threshold` and the depth is no plane
/// seen at a slant (second difference of 1/z relative to 1/z exceeds a quarter of it), where seen meets
/// unseen, and where a pixel is invalid. The outline of the photo is handled by border_distance.
std::vector<std::uint8_t> find_borders(const DepthMap& depth, float threshold);

/// Border mask [0,255]: min(distance to border - 1, distance to the photo's outline) / `full_width`, clamped.
/// The pixels beside a border weigh nothing, too: they hold the colours of both its sides.
std::vector<std::uint8_t> border_mask(const std::vector<float>& distance, int width, int height,
                                      float full_width);

}  // namespace vantage
