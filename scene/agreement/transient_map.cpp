#include "scene/agreement/transient_map.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/values/quantile.h"

namespace vantage {
namespace {

constexpr float tolerance = 0.35f;   ///< ln of linear light
constexpr float depth_step = 0.02f;  ///< largest relative depth difference within one surface
constexpr std::size_t max_compared = 6;

/// The texel at which another photo shows point `p`, given in that photo's camera space; null if the photo
/// does not see the point.
const TransientView::Texel* shown_at(const TransientView& v, const Eigen::Vector3f& p) {
    if (!(p.z() > 0)) return nullptr;
    const float x = float(v.k.fx) * p.x() / p.z() + float(v.k.cx),
                y = float(v.k.fy) * p.y() / p.z() + float(v.k.cy);
    if (!(x >= 1 && y >= 1 && x < float(v.width - 1) && y < float(v.height - 1))) return nullptr;
    const Grid texels = v.grid();
    const TransientView::Texel& t = texels(int(x), int(y));
    return std::abs(t.z - p.z()) <= depth_step * p.z() && std::isfinite(t.ln[0]) ? &t : nullptr;
}

using Others = std::array<const TransientView::Texel*, max_compared>;

/// The distance of a color from the range of colors in another photo, in channel `c`.
float outside(const float* ln, const TransientView::Texel& other, std::size_t c) {
    return std::max({0.0f, other.low[c] - ln[c], ln[c] - other.high[c]});
}

/// Whether the other photo also shows the color. If so, the color belongs to the scene, even if the mesh
/// lacks that part of the scene.
bool confirms(const TransientView::Texel& other, const float* ln) {
    return std::max({outside(ln, other, 0), outside(ln, other, 1), outside(ln, other, 2)}) <= tolerance;
}

float median(std::array<float, max_compared>& v, std::size_t n) {
    return upper_median(std::span(v).first(n));
}

/// The weight, in [0, 1], of a color that none of `n` other photos shows, computed from their texels at the
/// same place.
float weight_among(const float* ln, const Others& others, std::size_t n) {
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
        // The median of two values is not meaningful.
        spread = std::max(spread, n == 2 ? std::max(from_middle[0], from_middle[1]) : median(from_middle, n));
    }
    if (spread > tolerance) return 1;
    return std::clamp(2 - deviation / (tolerance + 2 * spread), 0.0f, 1.0f);
}

int clamped(int i, int n) { return std::clamp(i, 0, n - 1); }
/// Reflects a position at the first and the last of `n` elements; these two are not repeated.
int mirrored(int i, int n) { return clamped(i < 0 ? -i : i >= n ? 2 * n - 2 - i : i, n); }

/// The values of a row, padded with two values on each side.
template <class T>
class WideRow {
  public:
    explicit WideRow(int width) : width_(width), values_(std::size_t(width) + 4) {}
    T* data() { return values_.data() + 2; }
    /// Fills the padding from the row; `index`: clamped or mirrored.
    void extend(int (*index)(int, int)) {
        for (const int i : {-2, -1, width_, width_ + 1}) data()[i] = data()[index(i, width_)];
    }

  private:
    int width_;
    std::vector<T> values_;
};

std::uint8_t median_of(std::uint8_t a, std::uint8_t b, std::uint8_t c) {
    return std::max(std::min(a, b), std::min(std::max(a, b), c));
}

/// For each texel, the median of the 3x3 texels around it, found from sorted columns (Smith 1996); the edge
/// is repeated.
std::vector<std::uint8_t> median_3x3(Grid<const std::uint8_t> from) {
    std::vector<std::uint8_t> out(from.size());
    WideRow<std::uint8_t> low(from.width), middle(from.width), high(from.width);
    std::uint8_t *l = low.data(), *m = middle.data(), *h = high.data();
    for (int y = 0; y < from.height; ++y) {
        const auto *a = from.row(clamped(y - 1, from.height)).data(), *b = from.row(y).data(),
                   *c = from.row(clamped(y + 1, from.height)).data();
        for (int x = 0; x < from.width; ++x) {
            l[x] = std::min(std::min(a[x], b[x]), c[x]);
            m[x] = median_of(a[x], b[x], c[x]);
            h[x] = std::max(std::max(a[x], b[x]), c[x]);
        }
        for (auto* row : {&low, &middle, &high}) row->extend(clamped);
        auto* to = out.data() + std::size_t(y) * std::size_t(from.width);
        for (int x = 0; x < from.width; ++x)
            to[x] =
                median_of(std::max(std::max(l[x - 1], l[x]), l[x + 1]), median_of(m[x - 1], m[x], m[x + 1]),
                          std::min(std::min(h[x - 1], h[x]), h[x + 1]));
    }
    return out;
}

/// For each texel, the minimum of the texels around it: five in its own row and in the rows directly above
/// and below, and three in the next row on each side.
std::vector<std::uint8_t> least_around(Grid<const std::uint8_t> from) {
    std::vector<std::uint8_t> out(from.size());
    WideRow<std::uint8_t> least(from.width);
    std::uint8_t* l = least.data();
    for (int y = 0; y < from.height; ++y) {
        const auto row = [&](int j) { return from.row(clamped(j, from.height)).data(); };
        const auto *a = row(y - 2), *b = row(y - 1), *c = row(y), *d = row(y + 1), *e = row(y + 2);
        for (int x = 0; x < from.width; ++x) l[x] = std::min(std::min(b[x], c[x]), d[x]);
        least.extend(clamped);
        auto* to = out.data() + std::size_t(y) * std::size_t(from.width);
        for (int x = 0; x < from.width; ++x) {
            const std::uint8_t beside = std::min(std::min(l[x - 2], l[x - 1]), std::min(l[x + 1], l[x + 2]));
            to[x] = std::min(std::min(beside, l[x]), std::min(a[x], e[x]));
        }
    }
    return out;
}

/// A blur with the weights 1, 2, 1 in each direction.
std::vector<std::uint8_t> binomial_3x3(Grid<const std::uint8_t> from) {
    std::vector<std::uint8_t> out(from.size());
    WideRow<std::uint16_t> sums(from.width);
    std::uint16_t* s = sums.data();
    for (int y = 0; y < from.height; ++y) {
        const auto *a = from.row(mirrored(y - 1, from.height)).data(), *b = from.row(y).data(),
                   *c = from.row(mirrored(y + 1, from.height)).data();
        for (int x = 0; x < from.width; ++x) s[x] = std::uint16_t(a[x] + 2 * b[x] + c[x]);
        sums.extend(mirrored);
        auto* to = out.data() + std::size_t(y) * std::size_t(from.width);
        for (int x = 0; x < from.width; ++x) to[x] = std::uint8_t((s[x - 1] + 2 * s[x] + s[x + 1] + 8) / 16);
    }
    return out;
}

}  // namespace

std::vector<std::uint8_t> without_noise(const std::vector<std::uint8_t>& weight, int width, int height) {
    const auto median = median_3x3({weight.data(), width, height});
    const auto least = least_around({median.data(), width, height});
    return binomial_3x3({least.data(), width, height});
}

TransientMap transient_of(const TransientView& photo, std::span<const TransientView* const> others) {
    struct Relative {
        Eigen::Matrix3f R;
        Eigen::Vector3f t;
    };
    std::vector<Relative> to;
    for (const TransientView* o : others) {
        const Eigen::Matrix3d R = o->pose.R * photo.pose.R.transpose();
        to.push_back({R.cast<float>(), (o->pose.t - R * photo.pose.t).cast<float>()});
    }
    std::vector<std::uint8_t> raw(photo.texels.size(), 255);
    std::size_t compared = 0;
    const Grid texels = photo.grid();
    for (int y = 0; y < photo.height; ++y)
        for (int x = 0; x < photo.width; ++x) {
            const TransientView::Texel& t = texels(x, y);
            if (!std::isfinite(t.z) || !std::isfinite(t.ln[0])) continue;
            const Eigen::Vector3f p(float((x + 0.5 - photo.k.cx) / photo.k.fx) * t.z,
                                    float((y + 0.5 - photo.k.cy) / photo.k.fy) * t.z, t.z);
            Others seen;
            std::size_t n = 0;
            bool confirmed = false;
            for (std::size_t j = 0; j < others.size() && n < max_compared; ++j) {
                seen[n] = shown_at(*others[j], to[j].R * p + to[j].t);
                if (!seen[n]) continue;
                confirmed = confirmed || confirms(*seen[n], t.ln);
                if (++n >= 2 && confirmed) break;
            }
            if (n < 2) continue;
            ++compared;
            if (confirmed) continue;
            raw[std::size_t(y) * std::size_t(photo.width) + std::size_t(x)] =
                std::uint8_t(std::lround(255 * weight_among(t.ln, seen, n)));
        }
    TransientMap out{photo.width, photo.height, without_noise(raw, photo.width, photo.height), 0};
    const auto low = std::ranges::count_if(out.weight, [](std::uint8_t w) { return w < 128; });
    out.disagreeing = compared ? double(low) / double(compared) : 0;
    return out;
}

TransientMap transient_of(std::uint32_t photo, std::span<const std::uint32_t> partners,
                          const LruCache<TransientView>& views) {
    if (partners.size() < 2) return {};
    std::vector<std::shared_ptr<const TransientView>> held;
    for (const std::uint32_t other : partners) held.push_back(views.get(other));
    std::vector<const TransientView*> others;
    for (const auto& h : held) others.push_back(h.get());
    return transient_of(*views.get(photo), others);
}

}  // namespace vantage
