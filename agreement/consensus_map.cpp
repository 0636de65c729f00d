#include "agreement/consensus_map.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "values/quantile.h"

namespace vantage {
namespace {

constexpr float tolerance = 0.35f;   ///< ln of linear light
constexpr float depth_step = 0.02f;  ///< relative depth difference on one surface
constexpr std::size_t max_compared = 6;

/// What another photo shows at a point `p` of its camera space; null if it does not see it.
const ConsensusView::Texel* shown_at(const ConsensusView& v, const Eigen::Vector3f& p) {
    if (!(p.z() > 0)) return nullptr;
    const float x = float(v.k.fx) * p.x() / p.z() + float(v.k.cx),
                y = float(v.k.fy) * p.y() / p.z() + float(v.k.cy);
    if (!(x >= 1 && y >= 1 && x < float(v.width - 1) && y < float(v.height - 1))) return nullptr;
    const ConsensusView::Texel& t = v.grid()(int(x), int(y));
    return std::abs(t.z - p.z()) <= depth_step * p.z() && std::isfinite(t.ln[0]) ? &t : nullptr;
}

using Others = std::array<const ConsensusView::Texel*, max_compared>;

/// How far a color is outside the range that another photo shows.
float outside(const float* ln, const ConsensusView::Texel& other, std::size_t c) {
    return std::max({0.0f, other.low[c] - ln[c], ln[c] - other.high[c]});
}

/// Whether another photo shows the color, too: then it belongs to the scene, even if the mesh lacks it.
bool confirmed(const float* ln, const Others& others, std::size_t n) {
    return std::any_of(others.begin(), others.begin() + std::ptrdiff_t(n), [&](const auto* other) {
        return std::max({outside(ln, *other, 0), outside(ln, *other, 1), outside(ln, *other, 2)}) <=
               tolerance;
    });
}

float median(std::array<float, max_compared>& v, std::size_t n) {
    return upper_median(std::span(v).first(n));
}

/// Weight in [0, 1] of a color, given what `n` others show of the same place.
float weight_among(const float* ln, const Others& others, std::size_t n) {
    if (confirmed(ln, others, n)) return 1;
    float deviation = 0, spread = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        std::array<float, max_compared> values, off;
        for (std::size_t j = 0; j < n; ++j) {
            values[j] = others[j]->ln[c];
            off[j] = outside(ln, *others[j], c);
        }
        const float middle = median(values, n);
        deviation = std::max(deviation, median(off, n));
        std::array<float, max_compared> from_middle;
        for (std::size_t j = 0; j < n; ++j) from_middle[j] = std::abs(others[j]->ln[c] - middle);
        // The median of two is not meaningful.
        spread = std::max(spread, n == 2 ? std::max(from_middle[0], from_middle[1]) : median(from_middle, n));
    }
    if (spread > tolerance) return 1;
    return std::clamp(2 - deviation / (tolerance + 2 * spread), 0.0f, 1.0f);
}

/// Calls set(x, y) for every texel and stores what it returns.
template <class Value>
std::vector<std::uint8_t> filled(int width, int height, const Value& value) {
    std::vector<std::uint8_t> out;
    out.reserve(std::size_t(width) * std::size_t(height));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) out.push_back(value(x, y));
    return out;
}

/// Median of the 3x3 texels around each; the edge is repeated.
std::vector<std::uint8_t> median_3x3(Grid<const std::uint8_t> from) {
    return filled(from.width, from.height, [&](int x, int y) {
        std::array<std::uint8_t, 9> around;
        std::size_t n = 0;
        for (int j = y - 1; j <= y + 1; ++j)
            for (int i = x - 1; i <= x + 1; ++i)
                around[n++] = from(std::clamp(i, 0, from.width - 1), std::clamp(j, 0, from.height - 1));
        return upper_median(std::span<std::uint8_t>(around));
    });
}

/// Least of the texels around each: a row of five in it and in the rows beside it, and one two rows away.
std::vector<std::uint8_t> least_around(Grid<const std::uint8_t> from) {
    return filled(from.width, from.height, [&](int x, int y) {
        std::uint8_t least = 255;
        for (int j = std::max(y - 2, 0); j <= std::min(y + 2, from.height - 1); ++j) {
            const int reach = std::abs(j - y) == 2 ? 0 : 2;
            for (int i = std::max(x - reach, 0); i <= std::min(x + reach, from.width - 1); ++i)
                least = std::min(least, from(i, j));
        }
        return least;
    });
}

/// Mirrors a position at the first and the last of `n`, which are not repeated.
int mirrored(int i, int n) { return n == 1 ? 0 : i < 0 ? -i : i >= n ? 2 * n - 2 - i : i; }

/// Weights 1 2 1 in each direction.
std::vector<std::uint8_t> binomial_3x3(Grid<const std::uint8_t> from) {
    return filled(from.width, from.height, [&](int x, int y) {
        int sum = 0;
        for (int j = -1; j <= 1; ++j)
            for (int i = -1; i <= 1; ++i)
                sum += (2 - std::abs(i)) * (2 - std::abs(j)) *
                       from(mirrored(x + i, from.width), mirrored(y + j, from.height));
        return std::uint8_t((sum + 8) / 16);
    });
}

}  // namespace

std::vector<std::uint8_t> without_noise(const std::vector<std::uint8_t>& weight, int width, int height) {
    const auto median = median_3x3({weight.data(), width, height});
    const auto least = least_around({median.data(), width, height});
    return binomial_3x3({least.data(), width, height});
}

ConsensusMap consensus_of(const ConsensusView& photo, std::span<const ConsensusView* const> others) {
    struct Relative {
        Eigen::Matrix3f R;
        Eigen::Vector3f t;
    };
    std::vector<Relative> to;
    for (const ConsensusView* o : others) {
        const Eigen::Matrix3d R = o->pose.R * photo.pose.R.transpose();
        to.push_back({R.cast<float>(), (o->pose.t - R * photo.pose.t).cast<float>()});
    }
    std::vector<std::uint8_t> raw(photo.texels.size(), 255);
    std::size_t compared = 0;
    for (int y = 0; y < photo.height; ++y)
        for (int x = 0; x < photo.width; ++x) {
            const ConsensusView::Texel& t = photo.grid()(x, y);
            if (!std::isfinite(t.z) || !std::isfinite(t.ln[0])) continue;
            const Eigen::Vector3f p(float((x + 0.5 - photo.k.cx) / photo.k.fx) * t.z,
                                    float((y + 0.5 - photo.k.cy) / photo.k.fy) * t.z, t.z);
            Others seen;
            std::size_t n = 0;
            for (std::size_t j = 0; j < others.size() && n < max_compared; ++j) {
                seen[n] = shown_at(*others[j], to[j].R * p + to[j].t);
                n += seen[n] != nullptr;
            }
            if (n < 2) continue;
            ++compared;
            raw[std::size_t(y) * std::size_t(photo.width) + std::size_t(x)] =
                std::uint8_t(std::lround(255 * weight_among(t.ln, seen, n)));
        }
    ConsensusMap out{photo.width, photo.height, without_noise(raw, photo.width, photo.height), 0};
    const auto low = std::ranges::count_if(out.weight, [](std::uint8_t w) { return w < 128; });
    out.disagreeing = compared ? double(low) / double(compared) : 0;
    return out;
}

ConsensusMap consensus_of(std::uint32_t photo, std::span<const std::uint32_t> partners,
                          const LruCache<ConsensusView>& views) {
    if (partners.size() < 2) return {};
    std::vector<std::shared_ptr<const ConsensusView>> held;
    for (const std::uint32_t other : partners) held.push_back(views.get(other));
    std::vector<const ConsensusView*> others;
    for (const auto& h : held) others.push_back(h.get());
    return consensus_of(*views.get(photo), others);
}

}  // namespace vantage
