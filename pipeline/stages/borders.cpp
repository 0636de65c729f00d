#include "pipeline/stages/borders.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/values/grid.h"
#include "base/values/simd.h"

namespace vantage {
namespace {

/// Marks the pixels of a row, except its ends, whose 3x3 neighborhood contains a depth discontinuity or a
/// silhouette. Branch-free: an unseen neighbor is enough to make a pixel a border pixel, and the NaNs that
/// such a neighbor causes in the other test compare false.
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
        // 1/z is linear on a plane at any slant, but not across a step.
        const float inverse = 1 / z,
                    bend_x = std::abs(1 / d + 1 / e - 2 * inverse) * std::max(std::max(d, e), z),
                    bend_y = std::abs(1 / b + 1 / g - 2 * inverse) * std::max(std::max(b, g), z);
        const int step =
            int(gx * gx + gy * gy > least * least) & int(std::max(bend_x, bend_y) > threshold / 4);
        out[x] = std::uint8_t(outline | (step & (z < unseen)));
    }
}

VANTAGE_SIMD void border_row(const float* distance, int width, int edge, float scale, std::uint8_t* out) {
    constexpr float mixed = 1;  // px; pixels next to a border mix the colors of both sides
    for (int x = 0; x < width; ++x) {
        const float outline = float(std::min(edge, std::min(x, width - 1 - x))) + 0.5f;
        const float code = std::min(distance[x] - mixed, outline) * scale;
        out[x] = std::uint8_t(int(std::min(std::max(code, 0.0f), 255.0f) + 0.5f));
    }
}

}  // namespace

std::vector<std::uint8_t> find_borders(const DepthMap& d, float threshold) {
    std::vector<std::uint8_t> borders(d.z.size(), 0);
    const Grid<const float> z{d.z.data(), d.width, d.height};
    const Grid<std::uint8_t> border{borders.data(), d.width, d.height};
    for (int y = 1; y + 1 < d.height; ++y)
        find_in_row(z.row(y - 1).data(), z.row(y).data(), z.row(y + 1).data(), d.width, threshold,
                    border.row(y).data());
    for (std::size_t i = 0; i < d.valid.size(); ++i)
        if (d.valid[i] == 0) borders[i] = 1;
    return borders;
}

std::vector<std::uint8_t> border_weights(const std::vector<float>& distance, int width, int height,
                                         float full_width) {
    std::vector<std::uint8_t> weights(distance.size());
    const float scale = 255 / std::max(full_width, 1e-3f);
    const Grid<const float> from{distance.data(), width, height};
    const Grid<std::uint8_t> to{weights.data(), width, height};
    for (int y = 0; y < height; ++y)
        border_row(from.row(y).data(), width, std::min(y, height - 1 - y), scale, to.row(y).data());
    return weights;
}

}  // namespace vantage
