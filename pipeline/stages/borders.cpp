#include "pipeline/stages/borders.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pipeline/pixels/simd.h"

namespace vantage {
namespace {

/// Which pixels of a row, but for its ends, lie on a depth discontinuity, by their 3x3 neighbourhoods.
/// Without branches: what is no number compares false, and a neighbour that is not seen decides alone.
VANTAGE_SIMD void find_in_row(const float* above, const float* here, const float* below, int width,
                              float threshold, std::uint8_t* out) {
    constexpr float unseen = std::numeric_limits<float>::infinity();
    for (int x = 1; x + 1 < width; ++x) {
        const float a = above[x - 1], b = above[x], c = above[x + 1], d = here[x - 1], z = here[x],
                    e = here[x + 1], f = below[x - 1], g = below[x], h = below[x + 1];
        const int seen = (a < unseen) + (b < unseen) + (c < unseen) + (d < unseen) + (e < unseen) +
                         (f < unseen) + (g < unseen) + (h < unseen);
        const int outline = z < unseen ? seen != 8 : seen != 0;
        const float gx = (c + 2 * e + h) - (a + 2 * d + f), gy = (f + 2 * g + h) - (a + 2 * b + c);
        const float least = threshold * 8 * z;
        // A plane is linear in 1/z however steep; a step is not.
        const float inverse = 1 / z,
                    bend_x = std::abs(1 / d + 1 / e - 2 * inverse) * std::max(std::max(d, e), z),
                    bend_y = std::abs(1 / b + 1 / g - 2 * inverse) * std::max(std::max(b, g), z);
        const int step =
            int(gx * gx + gy * gy > least * least) & int(std::max(bend_x, bend_y) > threshold / 4);
        out[x] = std::uint8_t(outline | (step & (z < unseen)));
    }
}

VANTAGE_SIMD void border_row(const float* distance, int width, int edge, float scale, std::uint8_t* out) {
    constexpr float mixed = 1;  // pixels next to a border hold the colours of both sides
    for (int x = 0; x < width; ++x) {
        const float outline = float(std::min(edge, std::min(x, width - 1 - x))) + 0.5f;
        const float code = std::min(distance[x] - mixed, outline) * scale;
        out[x] = std::uint8_t(int(std::min(std::max(code, 0.0f), 255.0f) + 0.5f));
    }
}

}  // namespace

std::vector<std::uint8_t> find_borders(const DepthMap& d, float threshold) {
    std::vector<std::uint8_t> borders(d.z.size(), 0);
    for (int y = 1; y + 1 < d.height; ++y) {
        const float* here = d.z.data() + std::size_t(y) * std::size_t(d.width);
        find_in_row(here - d.width, here, here + d.width, d.width, threshold,
                    borders.data() + std::size_t(y) * std::size_t(d.width));
    }
    for (std::size_t i = 0; i < d.valid.size(); ++i)
        if (d.valid[i] == 0) borders[i] = 1;
    return borders;
}

std::vector<std::uint8_t> border_mask(const std::vector<float>& distance, int width, int height,
                                      float full_width) {
    std::vector<std::uint8_t> mask(distance.size());
    const float scale = 255 / std::max(full_width, 1e-3f);
    for (int y = 0; y < height; ++y) {
        const std::size_t row = std::size_t(y) * std::size_t(width);
        border_row(&distance[row], width, std::min(y, height - 1 - y), scale, &mask[row]);
    }
    return mask;
}

}  // namespace vantage
