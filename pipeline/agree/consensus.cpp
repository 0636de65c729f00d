#include "pipeline/agree/consensus.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <opencv2/imgproc.hpp>

#include "pipeline/judge/prediction.h"
#include "pipeline/judge/verdict.h"
#include "pipeline/run/for_each_photo.h"
#include "pipeline/stages/surface_samples.h"
#include "values/quantile.h"

namespace vantage {
namespace {

constexpr float tolerance = 0.35f;   ///< ln of linear light
constexpr float darkest = 0.004f;    ///< linear light; darker counts as this
constexpr float depth_step = 0.02f;  ///< relative depth difference on one surface
constexpr std::size_t max_compared = 6;
constexpr std::size_t neighbors = 6;  ///< that a photo chooses
constexpr float no_color = std::numeric_limits<float>::quiet_NaN();

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

/// Removes single texels, which are noise, and grows the rest over its blurred edges.
cv::Mat cleaned(const cv::Mat& raw) {
    cv::Mat out;
    cv::medianBlur(raw, out, 3);
    cv::erode(out, out, cv::getStructuringElement(cv::MORPH_ELLIPSE, {5, 5}));
    cv::GaussianBlur(out, out, {3, 3}, 0);
    return out;
}

}  // namespace

ConsensusView consensus_view(const CoarsePhoto& photo) {
    ConsensusView v{photo.k.width, photo.k.height, photo.k, photo.pose, {}};
    v.texels.resize(photo.texels.size());
    cv::Mat low(v.height, v.width, CV_32FC3), high(v.height, v.width, CV_32FC3);
    const float infinite = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < v.texels.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const float l = photo.texels[i].linear[c];
            const bool colored = std::isfinite(l);
            v.texels[i].z = photo.texels[i].z;
            v.texels[i].ln[c] = colored ? std::log(std::max(l, darkest)) : no_color;
            low.ptr<float>()[3 * i + c] = colored ? v.texels[i].ln[c] : infinite;
            high.ptr<float>()[3 * i + c] = colored ? v.texels[i].ln[c] : -infinite;
        }
    cv::erode(low, low, {});
    cv::dilate(high, high, {});
    for (std::size_t i = 0; i < v.texels.size(); ++i) {
        std::copy_n(low.ptr<float>() + 3 * i, 3, v.texels[i].low);
        std::copy_n(high.ptr<float>() + 3 * i, 3, v.texels[i].high);
    }
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
            Others seen;
            std::size_t n = 0;
            for (std::size_t j = 0; j < others.size() && n < max_compared; ++j) {
                seen[n] = shown_at(*others[j], to[j].R * p + to[j].t);
                n += seen[n] != nullptr;
            }
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

ConsensusPartners::ConsensusPartners(const SharedSurface& shared)
    : best_(shared.photos()), chosen_by_(shared.photos()) {
    for (std::uint32_t i = 0; i < shared.photos(); ++i)
        for (const PhotoPair& p : shared.best_pairs(i, neighbors + 1)) {
            best_[i].push_back(p.a == i ? p.b : p.a);
            chosen_by_[best_[i].back()].push_back(i);
        }
}

bool ConsensusPartners::chooses(std::uint32_t photo, std::uint32_t other,
                                std::optional<std::uint32_t> without) const {
    std::size_t n = 0;
    for (const std::uint32_t i : best_[photo]) {
        if (i == without) continue;
        if (n++ == neighbors) return false;
        if (i == other) return true;
    }
    return false;
}

std::vector<std::uint32_t> ConsensusPartners::of(std::uint32_t photo,
                                                 std::optional<std::uint32_t> without) const {
    std::vector<std::uint32_t> out;
    for (const std::uint32_t i : best_[photo])
        if (chooses(photo, i, without)) out.push_back(i);
    for (const std::uint32_t i : chosen_by_[photo])
        if (i != without && chooses(i, photo, without)) out.push_back(i);
    std::ranges::sort(out);
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
}

std::vector<ConsensusMap> consensus_maps(const ConsensusViews& uncorrected, const PhotoColors& colors,
                                         const ConsensusPartners& partners, unsigned threads) {
    const std::size_t n = colors.ln_gain.size();
    std::vector<ConsensusMap> out(n);
    LruCache<ConsensusView> views(cached_views, [&](std::uint32_t i) {
        return corrected(*uncorrected.get(i), colors.ln_gain[i], colors.falloff[i]);
    });
    for_each_photo(n, threads, [&](std::size_t i) {
        std::vector<std::shared_ptr<const ConsensusView>> held;
        for (const std::uint32_t other : partners.of(std::uint32_t(i))) held.push_back(views.get(other));
        if (held.size() < 2) return;
        std::vector<const ConsensusView*> others;
        for (const auto& h : held) others.push_back(h.get());
        out[i] = consensus_of(*views.get(std::uint32_t(i)), others);
    });
    return out;
}

namespace {

/// The maps of the photos that a fold's photo is predicted from; empty for the others.
std::vector<ConsensusMap> maps_without(const Folds& folds, const Fold& fold,
                                       const ConsensusPartners& partners, const PhotoColors& colors,
                                       const ConsensusViews& uncorrected) {
    std::map<std::uint32_t, ConsensusView> views;
    const auto view = [&](std::uint32_t i) -> const ConsensusView& {
        const auto it = views.find(i);
        if (it != views.end()) return it->second;
        return views.emplace(i, corrected(*uncorrected.get(i), colors.ln_gain[i], colors.falloff[i]))
            .first->second;
    };
    std::vector<ConsensusMap> out(folds.input().photos.size());
    for (const std::uint32_t i : fold.others) {
        std::vector<const ConsensusView*> others;
        for (const std::uint32_t other : partners.of(i, fold.photo)) others.push_back(&view(other));
        if (others.size() >= 2) out[i] = consensus_of(view(i), others);
    }
    return out;
}

}  // namespace

Judgment judge_consensus(const Folds& folds, const ConsensusViews& uncorrected,
                         const ConsensusPartners& partners, std::span<const PhotoColors> fits, bool gains_on,
                         bool falloff_on) {
    const FoldsInput& in = folds.input();
    std::vector<JudgedPhoto> photos(folds.all().size());
    folds.each([&](const Folds::View& v) {
        const auto kept = v.sightings();
        const Sightings& seen = *kept;
        const std::size_t f = v.index;
        const auto maps = maps_without(folds, v.fold, partners, fits[f], uncorrected);
        std::vector<Grid<const std::uint8_t>> weights;
        for (const ConsensusMap& m : maps)
            weights.push_back({m.weight.empty() ? nullptr : m.weight.data(), m.width, m.height});
        const Alternative without = alternative(fits[f], gains_on, falloff_on, v.fold.photo);
        Alternative with = without;
        with.consensus = weights;
        const std::array predictions{predict(v.target, seen, without), predict(v.target, seen, with)};
        const std::vector<JudgeScore> scores = score(own_color(v.target), predictions);
        photos[f] = {in.photos[v.fold.photo].name, scores[0], scores[1]};
    });
    return summarize(photos);
}

}  // namespace vantage
