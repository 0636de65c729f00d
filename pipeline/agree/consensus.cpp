#include "pipeline/agree/consensus.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "colors/color_fit.h"
#include "pipeline/package/tile_levels.h"
#include "pipeline/run/for_each_photo.h"
#include "pipeline/run/lru_cache.h"
#include "pipeline/stages/surface_samples.h"
#include "scene/error.h"
#include "scene/tiling.h"
#include "values/quantile.h"
#include "values/srgb.h"

namespace vantage {
namespace {

using package::Type;

constexpr float tolerance = 0.35f;   ///< ln of linear light
constexpr float depth_step = 0.02f;  ///< relative depth difference on one surface
constexpr std::size_t max_others = 6;
constexpr float no_color = std::numeric_limits<float>::quiet_NaN();

const std::array<float, 256>& ln_of_byte() {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> t;
        for (std::size_t i = 0; i < t.size(); ++i)
            t[i] = float(std::log(std::max(linear_of_srgb_byte()[i], 0.004)));
        return t;
    }();
    return table;
}

/// Colors in the 3x3 texels around a place in another photo: their range, and that of the place itself. ln of
/// linear light.
struct Shown {
    std::array<float, 3> low, high, middle;
};

/// False if the photo does not see `p`, which is in its camera space.
bool shown_at(const ConsensusView& v, const Eigen::Vector3f& p, Shown& out) {
    if (!(p.z() > 0)) return false;
    const float x = float(v.k.fx) * p.x() / p.z() + float(v.k.cx),
                y = float(v.k.fy) * p.y() / p.z() + float(v.k.cy);
    if (!(x >= 1 && y >= 1 && x < float(v.width - 1) && y < float(v.height - 1))) return false;
    const ConsensusView::Texel* middle = &v.grid()(int(x), int(y));
    if (!(std::abs(middle->z - p.z()) <= depth_step * p.z()) || !std::isfinite(middle->ln[0])) return false;
    for (std::size_t c = 0; c < 3; ++c) out.low[c] = out.high[c] = out.middle[c] = middle->ln[c];
    for (std::ptrdiff_t j = -1; j <= 1; ++j)
        for (std::ptrdiff_t i = -1; i <= 1; ++i) {
            const auto& t = middle[j * v.width + i];
            if (!std::isfinite(t.ln[0])) continue;
            for (std::size_t c = 0; c < 3; ++c) {
                out.low[c] = std::min(out.low[c], t.ln[c]);
                out.high[c] = std::max(out.high[c], t.ln[c]);
            }
        }
    return true;
}

float median(std::array<float, max_others>& v, std::size_t n) { return upper_median(std::span(v).first(n)); }

/// Weight in [0, 1] of a color, given what `n` others show of the same place.
float weight_among(const float* ln, const std::array<Shown, max_others>& others, std::size_t n) {
    float deviation = 0, spread = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        std::array<float, max_others> values, off;
        for (std::size_t j = 0; j < n; ++j) {
            values[j] = others[j].middle[c];
            off[j] = std::max({0.0f, others[j].low[c] - ln[c], ln[c] - others[j].high[c]});
        }
        const float middle = median(values, n);
        deviation = std::max(deviation, median(off, n));
        std::array<float, max_others> from_middle;
        for (std::size_t j = 0; j < n; ++j) from_middle[j] = std::abs(others[j].middle[c] - middle);
        // The median of two is not meaningful.
        spread = std::max(spread, n == 2 ? std::max(from_middle[0], from_middle[1]) : median(from_middle, n));
    }
    if (spread > tolerance) return 1;
    return std::clamp(2 - deviation / (tolerance + 2 * spread), 0.0f, 1.0f);
}

/// Removes single texels, which are noise, and grows the rest over its blurred edges.
cv::Mat cleaned(const cv::Mat& raw) {
    cv::Mat out;
    cv::medianBlur(raw, out, 3);
    cv::erode(out, out, cv::getStructuringElement(cv::MORPH_ELLIPSE, {5, 5}));
    cv::GaussianBlur(out, out, {3, 3}, 0);
    return out;
}

}  // namespace

ConsensusView read_consensus_view(const PackageReader& package, const package::PhotoRecord& r,
                                  std::uint32_t photo, int level) {
    const int l = std::clamp(level, 0, std::max(int(r.levels) - 1, 0)), zl = std::max(l, mask_level);
    const Level size = level_size(int(r.width), int(r.height), l),
                deep = level_size(int(r.width), int(r.height), zl);
    ConsensusView v{size.width, size.height, intrinsics(r).at_level(l), cam_from_origin(r), {}};
    const auto rgba = read_level(package, r, photo, Type::tiles, l),
               z = read_level(package, r, photo, Type::depth, zl);
    v.texels.resize(std::size_t(size.width) * std::size_t(size.height));
    const Falloff falloff{double(r.falloff[0]), double(r.falloff[1]), double(r.falloff[2])};
    const float gain[3] = {float(std::log(r.gain[0])), float(std::log(r.gain[1])),
                           float(std::log(r.gain[2]))};
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const std::size_t at = std::size_t(y) * std::size_t(size.width) + std::size_t(x);
            const std::size_t below =
                std::size_t(y >> (zl - l)) * std::size_t(deep.width) + std::size_t(x >> (zl - l));
            ConsensusView::Texel& t = v.texels[at];
            std::memcpy(&t.z, &z[4 * below], 4);
            const auto lens = float(log_falloff(falloff, falloff_radius(v.k, {x + 0.5, y + 0.5})));
            for (std::size_t c = 0; c < 3; ++c)
                t.ln[c] = std::to_integer<int>(rgba[4 * at + 3]) < 255
                              ? no_color
                              : ln_of_byte()[std::to_integer<std::size_t>(rgba[4 * at + c])] + gain[c] + lens;
        }
    return v;
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
    cv::Mat raw(photo.height, photo.width, CV_8U, cv::Scalar(255));
    std::size_t compared = 0;
    for (int y = 0; y < photo.height; ++y)
        for (int x = 0; x < photo.width; ++x) {
            const ConsensusView::Texel& t = photo.grid()(x, y);
            if (!std::isfinite(t.z) || !std::isfinite(t.ln[0])) continue;
            const Eigen::Vector3f p(float((x + 0.5 - photo.k.cx) / photo.k.fx) * t.z,
                                    float((y + 0.5 - photo.k.cy) / photo.k.fy) * t.z, t.z);
            std::array<Shown, max_others> seen;
            std::size_t n = 0;
            for (std::size_t j = 0; j < others.size() && n < max_others; ++j)
                n += shown_at(*others[j], to[j].R * p + to[j].t, seen[n]);
            if (n < 2) continue;
            ++compared;
            raw.at<std::uint8_t>(y, x) = std::uint8_t(std::lround(255 * weight_among(t.ln, seen, n)));
        }
    const cv::Mat clean = cleaned(raw);
    ConsensusMap out{photo.width, photo.height, {clean.begin<std::uint8_t>(), clean.end<std::uint8_t>()}, 0};
    const auto low = std::ranges::count_if(out.weight, [](std::uint8_t w) { return w < 128; });
    out.disagreeing = compared ? double(low) / double(compared) : 0;
    return out;
}

std::vector<ConsensusMap> consensus_maps(const PackageReader& package,
                                         std::span<const package::PhotoRecord> photos,
                                         std::span<const PhotoPair> pairs, int level, unsigned threads) {
    std::vector<ConsensusMap> out(photos.size());
    LruCache<ConsensusView> views(
        16, [&](std::uint32_t photo) { return read_consensus_view(package, photos[photo], photo, level); });
    for_each_photo(photos.size(), threads, [&](std::size_t i) {
        std::vector<std::shared_ptr<const ConsensusView>> held;
        for (const PhotoPair& p : pairs)
            if (p.a == i || p.b == i) held.push_back(views.get(p.a == i ? p.b : p.a));
        if (held.size() < 2) return;
        std::vector<const ConsensusView*> others;
        for (const auto& h : held) others.push_back(h.get());
        out[i] = consensus_of(*views.get(std::uint32_t(i)), others);
        package.forget_all();
    });
    return out;
}

}  // namespace vantage
