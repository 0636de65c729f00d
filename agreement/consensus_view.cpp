#include "agreement/consensus_view.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "agreement/read_level.h"
#include "values/srgb.h"

namespace vantage {
namespace {

using package::Type;

constexpr float darkest = 0.004f;  ///< linear light; darker counts as this
constexpr float no_color = std::numeric_limits<float>::quiet_NaN();

}  // namespace

void set_color(ConsensusView::Texel& t, const float* linear, float z) {
    t.z = z;
    for (std::size_t c = 0; c < 3; ++c)
        t.ln[c] = std::isfinite(linear[c]) ? std::log(std::max(linear[c], darkest)) : no_color;
}

void find_ranges(ConsensusView& v) {
    const Grid<ConsensusView::Texel> grid{v.texels.data(), v.width, v.height};
    for (int y = 0; y < v.height; ++y)
        for (int x = 0; x < v.width; ++x)
            for (std::size_t c = 0; c < 3; ++c) {
                float low = std::numeric_limits<float>::infinity(), high = -low;
                for (int j = std::max(y - 1, 0); j <= std::min(y + 1, v.height - 1); ++j)
                    for (int i = std::max(x - 1, 0); i <= std::min(x + 1, v.width - 1); ++i) {
                        const float ln = grid(i, j).ln[c];
                        if (!std::isfinite(ln)) continue;
                        low = std::min(low, ln), high = std::max(high, ln);
                    }
                grid(x, y).low[c] = low, grid(x, y).high[c] = high;
            }
}

int consensus_level(const package::PhotoRecord& r) { return std::max(coarse_level(r, 256) - 1, mask_level); }

ConsensusView read_consensus_view(const PackageReader& package, const package::PhotoRecord& r,
                                  std::uint32_t photo, int level) {
    const int of_colors = std::clamp(level, 0, std::max(int(r.levels) - 1, 0));
    const int finer = level - of_colors;  // 1 for a photo of a single level, whose masks are half its size
    const Intrinsics k = intrinsics(r).at_level(level);
    ConsensusView v{k.width, k.height, k, cam_from_origin(r), {}};
    const auto rgba = read_level(package, r, photo, Type::tiles, of_colors),
               depth = read_level(package, r, photo, Type::depth, level);
    const Level size = level_size(int(r.width), int(r.height), of_colors);
    v.texels.resize(v.grid().size());
    for (int y = 0; y < v.height; ++y)
        for (int x = 0; x < v.width; ++x) {
            const std::size_t at = std::size_t(y) * std::size_t(v.width) + std::size_t(x);
            const std::byte* color =
                &rgba[4 * (std::size_t(std::min(y << finer, size.height - 1)) * std::size_t(size.width) +
                           std::size_t(std::min(x << finer, size.width - 1)))];
            float linear[3], z;
            for (std::size_t c = 0; c < 3; ++c)
                linear[c] = color[3] == std::byte(255)
                                ? float(linear_of_srgb_byte()[std::to_integer<std::size_t>(color[c])])
                                : no_color;
            std::memcpy(&z, &depth[4 * at], 4);
            set_color(v.texels[at], linear, z);
        }
    find_ranges(v);
    return v;
}

ConsensusView corrected(ConsensusView v, const std::array<double, 3>& ln_gain, const Falloff& falloff) {
    const bool lens = falloff != Falloff{};
    for (int y = 0; y < v.height; ++y)
        for (int x = 0; x < v.width; ++x) {
            ConsensusView::Texel& t = v.texels[std::size_t(y) * std::size_t(v.width) + std::size_t(x)];
            const double off = lens ? log_falloff(falloff, falloff_radius(v.k, {x + 0.5, y + 0.5})) : 0;
            for (std::size_t c = 0; c < 3; ++c) {
                const auto by = float(ln_gain[c] + off);
                t.ln[c] += by, t.low[c] += by, t.high[c] += by;
            }
        }
    return v;
}

}  // namespace vantage
