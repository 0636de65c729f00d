#include "pipeline/stages/masks.h"

#include <algorithm>
#include <cmath>

namespace vantage {

std::vector<std::uint8_t> combine_masks(const PhotoGeometry& g, const std::vector<std::uint8_t>& border,
                                        double focal, double reference_density) {
    std::vector<std::uint8_t> out(g.z.size() * 4, 0);
    const float top = float(std::log2(focal / reference_density));
    for (std::size_t i = 0; i < g.z.size(); ++i) {
        if (!std::isfinite(g.z[i]) || !(g.z[i] > 0)) continue;
        const float code = 255 + 12 * (top - std::log2(g.z[i]));
        out[4 * i] = g.angle[i];
        out[4 * i + 1] = std::uint8_t(std::clamp(code, 1.0f, 255.0f) + 0.5f);
        out[4 * i + 2] = border[i];
        out[4 * i + 3] = 255;
    }
    return out;
}

}  // namespace vantage
