#pragma once
#include <cstdint>
#include <vector>

namespace vantage {

/// Linear depth (+inf: nothing seen) and validity (0: the photo has no pixel there; empty: all valid), row by
/// row.
struct DepthMap {
    int width = 0, height = 0;
    std::vector<float> z;
    std::vector<std::uint8_t> valid;
};

/// 1 at depth discontinuities, silhouettes and invalid pixels, otherwise 0 [C, M]. A discontinuity is a Sobel
/// 3x3 response, relative to depth, above `threshold`, with a second difference of 1/z, relative to 1/z,
/// above threshold / 4; the latter spares planes seen at a slant. The photo's outline is left to
/// border_weights().
std::vector<std::uint8_t> find_borders(const DepthMap& depth, float threshold);

/// Border weight, 255 times min(distance to the border - 1, distance to the photo's outline) / `full_width`,
/// clamped to [0, 255]. Distances and `full_width` are in pixels of the weight map. The 1 excludes pixels
/// next to a border, which mix the colors of both sides.
std::vector<std::uint8_t> border_weights(const std::vector<float>& distance, int width, int height,
                                         float full_width);

}  // namespace vantage
