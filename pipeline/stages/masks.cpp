#include "pipeline/stages/masks.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "scene/tiling.h"

namespace vantage {

namespace {

/// log2 of positive finite floats, to 1/2048 of an octave: by exponent and the mantissa's first bits.
class Log2 {
  public:
    Log2() {
        for (std::size_t i = 0; i < table_.size(); ++i)
            table_[i] = float(std::log2(1 + (double(i) + 0.5) / double(table_.size())));
    }
    float operator()(float z) const {
        const auto bits = std::bit_cast<std::uint32_t>(z);
        return float(int(bits >> 23) - 127) + table_[bits >> 12 & 2047];
    }

  private:
    std::array<float, 2048> table_;
};

}  // namespace

std::vector<std::uint8_t> combine_masks(const PhotoGeometry& g, const std::vector<std::uint8_t>& border,
                                        double focal, double reference_density) {
    static const Log2 log2;
    std::vector<std::uint8_t> out(g.z.size() * 4, 0);
    const float top = float(std::log2(focal / reference_density));
    for (std::size_t i = 0; i < g.z.size(); ++i) {
        if (!(g.z[i] > 0 && g.z[i] < std::numeric_limits<float>::infinity())) continue;
        const float code = 255 + 12 * (top - log2(g.z[i]));
        out[4 * i] = g.angle[i];
        out[4 * i + 1] = std::uint8_t(std::clamp(code, 1.0f, 255.0f) + 0.5f);
        out[4 * i + 2] = border[i];
        out[4 * i + 3] = 255;
    }
    return out;
}

MaskLevel halve(const MaskLevel& level) {
    const Level half = level_size(level.width, level.height, 1);
    const std::size_t texels = std::size_t(half.width) * std::size_t(half.height);
    MaskLevel out{half.width, half.height, std::vector<std::uint8_t>(texels * 4, 0),
                  std::vector<float>(texels, std::numeric_limits<float>::infinity())};
    std::size_t to = 0;
    for (int y = 0; y < half.height; ++y)
        for (int x = 0; x < half.width; ++x, ++to) {
            unsigned sum[3]{}, valid = 0;
            float farthest = 0;
            for (int j = 2 * y; j <= std::min(2 * y + 1, level.height - 1); ++j)
                for (int i = 2 * x; i <= std::min(2 * x + 1, level.width - 1); ++i) {
                    const std::size_t from = std::size_t(j) * std::size_t(level.width) + std::size_t(i);
                    if (!level.masks[4 * from + 3]) continue;
                    ++valid;
                    for (std::size_t c = 0; c < 3; ++c) sum[c] += level.masks[4 * from + c];
                    farthest = std::max(farthest, level.z[from]);
                }
            if (!valid) continue;
            for (std::size_t c = 0; c < 3; ++c)
                out.masks[4 * to + c] = std::uint8_t((sum[c] + valid / 2) / valid);
            out.masks[4 * to + 3] = 255;
            out.z[to] = farthest;
        }
    return out;
}

}  // namespace vantage
