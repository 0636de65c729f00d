#include "pipeline/stages/weight_maps.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "base/values/bytes_of.h"
#include "base/values/simd.h"
#include "base/values/tiling.h"
#include "pipeline/stages/borders.h"
#include "pipeline/stages/tile_levels.h"

namespace vantage {
namespace {

static_assert(std::endian::native == std::endian::little);

/// log2 of a positive normal float, to within 2e-5: the exponent plus a polynomial in the mantissa, fitted to
/// log2(1 + m) and exact at both ends.
inline float log2_of(float z) {
    const auto bits = std::bit_cast<std::uint32_t>(z);
    const float m = std::bit_cast<float>((bits & 0x7fffffu) | 0x3f800000u) - 1;
    const float fraction =
        m * (1.44191703f + m * (-0.70909640f + m * (0.41560593f + m * (-0.19357557f + m * 0.04514900f))));
    return float(int(bits >> 23) - 127) + fraction;
}

/// `top` is 255 + 12 log2(focal / reference).
VANTAGE_SIMD void combine(const float* z, const std::uint8_t* angle, const std::uint8_t* border, float top,
                          std::size_t count, std::uint8_t* out) {
    for (std::size_t i = 0; i < count; ++i) {
        const float code = std::min(std::max(top - 12 * log2_of(z[i]), 1.0f), 255.0f);
        const std::uint32_t texel = std::uint32_t(angle[i]) | std::uint32_t(int(code + 0.5f)) << 8 |
                                    std::uint32_t(border[i]) << 16 | 0xff000000u;
        const bool seen = (z[i] > 0) & (z[i] < std::numeric_limits<float>::infinity());
        const std::uint32_t kept = seen ? texel : 0;
        std::memcpy(out + 4 * i, &kept, 4);
    }
}

/// Four texels to be reduced to one.
struct Quad {
    std::uint32_t weights[4];
    float z[4];

    bool all_valid() const { return (weights[0] & weights[1] & weights[2] & weights[3]) >> 31; }
    bool none_valid() const { return !((weights[0] | weights[1] | weights[2] | weights[3]) >> 31); }

    std::uint32_t mean_of_all() const {
        std::uint32_t even = 0x20002, odd = 2;
        for (const std::uint32_t m : weights) even += m & 0xff00ff, odd += m >> 8 & 0xff;
        return (even >> 2 & 0xff00ff) | (odd >> 2) << 8 | 0xff000000u;
    }
    std::uint32_t mean_of_valid() const {
        std::uint32_t valid = 0, out = 0xff000000u;
        for (const std::uint32_t m : weights) valid += m >> 31;
        for (int shift = 0; shift < 24; shift += 8) {
            std::uint32_t sum = valid / 2;
            for (const std::uint32_t m : weights) sum += m >> 31 ? m >> shift & 0xff : 0;
            out |= sum / valid << shift;
        }
        return out;
    }
    float farthest() const {
        float far = 0;
        for (int i = 0; i < 4; ++i) far = std::max(far, weights[i] >> 31 ? z[i] : 0);
        return far;
    }
};

}  // namespace

std::vector<std::uint8_t> combine_weights(const std::vector<float>& z, const std::vector<std::uint8_t>& angle,
                                          const std::vector<std::uint8_t>& border, double focal,
                                          double reference_density) {
    std::vector<std::uint8_t> out(4 * z.size());
    combine(z.data(), angle.data(), border.data(), float(255 + 12 * std::log2(focal / reference_density)),
            z.size(), out.data());
    return out;
}

WeightMapLevel halve(const WeightMapLevel& level) {
    const Level half = level_size(level.width, level.height, 1);
    const std::size_t texels = std::size_t(half.width) * std::size_t(half.height);
    WeightMapLevel out{half.width, half.height, std::vector<std::uint8_t>(texels * 4, 0),
                       std::vector<float>(texels, std::numeric_limits<float>::infinity())};
    const auto width = std::size_t(level.width);
    std::size_t to = 0;
    for (int y = 0; y < half.height; ++y) {
        const std::size_t row = std::size_t(2 * y) * width, below = 2 * y + 1 < level.height ? width : 0;
        for (int x = 0; x < half.width; ++x, ++to) {
            const std::size_t from = row + std::size_t(2 * x), right = 2 * x + 1 < level.width ? 1 : 0;
            const std::size_t at[4] = {from, from + right, from + below, from + below + right};
            Quad q;
            for (int i = 0; i < 4; ++i) {
                std::memcpy(&q.weights[i], &level.weights[4 * at[i]], 4);
                q.z[i] = level.z[at[i]];
            }
            if (q.none_valid()) continue;
            const std::uint32_t mean = q.all_valid() ? q.mean_of_all() : q.mean_of_valid();
            std::memcpy(&out.weights[4 * to], &mean, 4);
            out.z[to] = q.farthest();
        }
    }
    return out;
}

void make_weight_maps(StageInput& in) {
    std::vector<std::uint8_t> valid = std::move(in.pixels().valid);
    if (valid.empty() && in.photo.lens) valid = inside_photo(*in.photo.lens, weight_map_level);
    const GeometryContext& c = in.context;
    const Traced traced(c.trace, "weight maps", in.photo.name);
    const Intrinsics& k = in.photo.intrinsics;
    DepthMap depth{in.geometry.width, in.geometry.height, in.geometry.z, std::move(valid)};
    const double full = border_width * k.width / 3072 / (1 << weight_map_level);
    const auto borders = find_borders(depth, float(border_threshold));
    const auto border =
        border_weights(c.renderer.distances(borders, depth.width, depth.height, int(full) + 3), depth.width,
                       depth.height, float(full));
    auto combined =
        combine_weights(depth.z, in.geometry.angle, border, std::sqrt(k.fx * k.fy), c.reference_density);
    WeightMapLevel level{depth.width, depth.height, std::move(combined), std::move(depth.z)};
    for (int l = weight_map_level;; ++l) {
        const Level size{level.width, level.height};
        write_tiles(c.writer, package::Type::weight_maps, in.photo.index, std::uint32_t(l),
                    {bytes_of(level.weights), size});
        write_tiles(c.writer, package::Type::depth, in.photo.index, std::uint32_t(l),
                    {bytes_of(level.z), size});
        if (l + 1 == weight_map_levels_end(int(in.record.levels))) return;
        level = halve(level);
    }
}

}  // namespace vantage
