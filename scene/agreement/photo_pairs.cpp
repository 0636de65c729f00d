#include "scene/agreement/photo_pairs.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "base/values/quantile.h"
#include "scene/package/package_reader.h"

namespace vantage {
namespace {

constexpr std::uint32_t min_shared = 30;
constexpr std::size_t max_compared = 128;

using Bits = std::vector<std::uint64_t>;

Bits seen_discs(std::span<const package::SampleRecord> samples) {
    Bits bits((samples.size() + 63) / 64);
    for (std::size_t d = 0; d < samples.size(); ++d)
        if (shown(samples[d])) bits[d / 64] |= std::uint64_t(1) << d % 64;
    return bits;
}

std::uint32_t count_shared(const Bits& a, const Bits& b) {
    std::uint32_t n = 0;
    for (std::size_t w = 0; w < std::min(a.size(), b.size()); ++w)
        n += std::uint32_t(std::popcount(a[w] & b[w]));
    return n;
}

}  // namespace

double worth(const PhotoPair& p) { return p.shared * std::exp(-std::pow(p.angle / 0.35, 2)); }

SharedSurface::SharedSurface(std::span<const package::PhotoRecord> photos, Samples samples,
                             std::span<const SurfaceDisc> discs)
    : samples_(samples), discs_(discs) {
    for (std::size_t i = 0; i < photos.size(); ++i) {
        seen_.push_back(seen_discs(samples[i]));
        eyes_.push_back(cam_from_origin(photos[i]).center());
        image_set_.push_back(photos[i].image_set);
    }
}

/// Computes the pair's median angle and color difference from a subset of about `max_compared` discs.
void SharedSurface::compare(PhotoPair& pair) const {
    const Bits &a = seen_[pair.a], &b = seen_[pair.b];
    std::vector<double> angles, colors;
    const std::size_t step = 1 + pair.shared / max_compared;
    std::size_t n = 0;
    for (std::size_t d = 0; d < discs_.size() && d / 64 < std::min(a.size(), b.size()); ++d) {
        if (!((a[d / 64] & b[d / 64]) >> d % 64 & 1) || n++ % step) continue;
        const Eigen::Vector3d x = discs_[d].center.cast<double>(),
                              to_a = (eyes_[pair.a] - x).stableNormalized(),
                              to_b = (eyes_[pair.b] - x).stableNormalized();
        angles.push_back(std::atan2(to_a.cross(to_b).norm(), to_a.dot(to_b)));
        double color = 0;
        for (int c = 0; c < 3; ++c)
            color += std::abs(std::log(std::max(1.0, double(samples_[pair.a][d].linear[c])) /
                                       std::max(1.0, double(samples_[pair.b][d].linear[c])))) /
                     3;
        colors.push_back(color);
    }
    pair.angle = quantile(std::move(angles), 0.5);
    pair.color = quantile(std::move(colors), 0.5);
}

/// The pair with its angle and color difference, which are computed on first use.
PhotoPair SharedSurface::compared(const PhotoPair& pair) const {
    const std::pair key(pair.a, pair.b);
    {
        const std::scoped_lock lock(mutex_);
        if (const auto known = compared_.find(key); known != compared_.end()) return known->second;
    }
    PhotoPair out = pair;
    compare(out);
    const std::scoped_lock lock(mutex_);
    return compared_.emplace(key, out).first->second;
}

std::vector<PhotoPair> SharedSurface::most_shared(std::uint32_t a, std::size_t count) const {
    std::vector<PhotoPair> pairs;
    for (std::uint32_t b = 0; b < seen_.size(); ++b)
        if (const std::uint32_t n =
                a == b || image_set_[a] != image_set_[b] ? 0 : count_shared(seen_[a], seen_[b]);
            n >= min_shared)
            pairs.push_back({std::min(a, b), std::max(a, b), n});
    std::ranges::stable_sort(pairs, std::greater{}, &PhotoPair::shared);
    pairs.resize(std::min(pairs.size(), count));
    // Angles take longer to compute than counts, so they are computed only for candidates.
    for (PhotoPair& p : pairs) p = compared(p);
    return pairs;
}

std::vector<PhotoPair> SharedSurface::best_pairs(std::uint32_t a, std::size_t count) const {
    std::vector<PhotoPair> pairs = most_shared(a, candidates_of(count));
    std::ranges::stable_sort(pairs, std::greater{}, worth);
    pairs.resize(std::min(pairs.size(), count));
    return pairs;
}

std::vector<PhotoPair> photo_pairs(const SharedSurface& shared, std::size_t per_photo) {
    std::vector<PhotoPair> chosen;
    for (std::uint32_t a = 0; a < shared.photos(); ++a) {
        const std::vector<PhotoPair> pairs = shared.best_pairs(a, per_photo);
        chosen.insert(chosen.end(), pairs.begin(), pairs.end());
    }
    const auto order = [](const PhotoPair& p) { return std::pair(p.a, p.b); };
    std::ranges::sort(chosen, {}, order);
    const auto same = [&](const PhotoPair& p, const PhotoPair& q) { return order(p) == order(q); };
    chosen.erase(std::unique(chosen.begin(), chosen.end(), same), chosen.end());
    return chosen;
}

std::vector<PhotoPair> photo_pairs(std::span<const package::PhotoRecord> photos, Samples samples,
                                   std::span<const SurfaceDisc> discs, std::size_t per_photo) {
    return photo_pairs(SharedSurface(photos, samples, discs), per_photo);
}

}  // namespace vantage
