#include "scene/agreement/transient_view.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "scene/agreement/read_level.h"

namespace vantage {
namespace {

using package::Type;

constexpr float darkest = 0.004f;  ///< linear light; darker values are raised to this value
constexpr float no_color = std::numeric_limits<float>::quiet_NaN();

}  // namespace

void set_color(TransientView::Texel& t, const float* linear, float z) {
    t.z = z;
    for (std::size_t c = 0; c < 3; ++c)
        t.ln[c] = std::isfinite(linear[c]) ? std::log(std::max(linear[c], darkest)) : no_color;
}

void find_ranges(TransientView& v) {
    const Grid<TransientView::Texel> grid{v.texels.data(), v.width, v.height};
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

int transient_level(const package::PhotoRecord& r) {
    return std::max(coarse_level(r, 256) - 1, weight_map_level);
}

TransientView read_transient_view(const PackageReader& package, const package::PhotoRecord& r,
                                  std::uint32_t photo, int level) {
    const Intrinsics k = intrinsics(r).at_level(level);
    TransientView v{k.width, k.height, k, cam_from_origin(r), {}};
    const auto colors = read_linear_colors(package, r, photo, level);
    const auto depth = read_level(package, r, photo, Type::depth, level);
    v.texels.resize(v.grid().size());
    for (std::size_t i = 0; i < v.texels.size(); ++i) {
        float z;
        std::memcpy(&z, &depth[4 * i], 4);
        set_color(v.texels[i], colors[i].data(), z);
    }
    find_ranges(v);
    return v;
}

TransientView corrected(TransientView v, const std::array<double, 3>& ln_gain, const Vignetting& vignetting) {
    const bool lens = vignetting != Vignetting{};
    for (int y = 0; y < v.height; ++y)
        for (int x = 0; x < v.width; ++x) {
            TransientView::Texel& t = v.texels[std::size_t(y) * std::size_t(v.width) + std::size_t(x)];
            const double off =
                lens ? log_vignetting(vignetting, vignetting_radius(v.k, {x + 0.5, y + 0.5})) : 0;
            for (std::size_t c = 0; c < 3; ++c) {
                const auto by = float(ln_gain[c] + off);
                t.ln[c] += by, t.low[c] += by, t.high[c] += by;
            }
        }
    return v;
}

}  // namespace vantage
