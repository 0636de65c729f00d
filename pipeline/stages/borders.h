#pragma once
#include <cstdint>
#include <vector>

namespace vantage {

/// Linear depth (+inf: nothing is visible) and validity (0: the photo has no pixel there; empty: all pixels
/// are valid), row by row.
struct DepthMap {
    int width = 0, height = 0;
    std::vector<float> z;
    std::vector<std::uint8_t> valid;
};

/// Distance from a border at which the border weight reaches 1, in pixels of a photo 3072 px wide.
inline constexpr double border_width = 64;
/// Minimum depth step at a border, relative to depth, per pixel of the weight map.
inline constexpr double border_threshold = 0.01;

/// 1 at depth discontinuities, silhouettes and invalid pixels, otherwise 0 [C, M]. At a discontinuity, the
/// Sobel 3x3 response relative to depth exceeds `threshold`, and the second difference of 1/z relative to 1/z
/// exceeds threshold / 4. The second condition excludes planes seen at a slant. The photo's outline is
/// handled by border_weights().
std::vector<std::uint8_t> find_borders(const DepthMap& depth, float threshold);

/// Border weight: 255 times min(distance to the border - 1, distance to the photo's outline) / `full_width`,
/// clamped to [0, 255]. Distances and `full_width` are in pixels of the weight map. Subtracting 1 excludes
/// pixels next to a border, which mix the colors of both sides.
std::vector<std::uint8_t> border_weights(const std::vector<float>& distance, int width, int height,
                                         float full_width);

}  // namespace vantage
