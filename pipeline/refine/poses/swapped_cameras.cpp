#include "pipeline/refine/poses/swapped_cameras.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/values/lru_cache.h"

namespace vantage {
namespace {

using package::PairRecord;

constexpr int matched_side = 800, corners_of_neighbor = 300;
/// Fractions of the longer side. Pairs displaced by more than `near` are suspect, and matches displaced by
/// more than `far_away` do not fit. The first limit distinguishes cameras from their neighbors; the second
/// allows for inexact cameras.
constexpr double near = 0.003, far_away = 0.01;
constexpr double min_fit = 0.4;   ///< minimum fraction of corners that match
constexpr double min_better = 2;  ///< minimum ratio to the fit with the given cameras
constexpr int max_neighbors = 3;
constexpr std::size_t max_suspects = 12;

double longer_side(const package::PhotoRecord& p) { return double(std::max(p.width, p.height)); }

/// Whether the photos of the pair contradict each other, or are displaced by more than inexact cameras can
/// explain.
bool is_bad(const PoseRefinementInput& in, const PairRecord& p) {
    return contradicts(p) || (trusted(p) && double(p.median) > near * longer_side(in.photos[p.a]));
}

struct Counts {
    std::size_t all = 0, bad = 0, contradicting = 0;
};
/// Counts the pairs of each photo, except pairs with a photo to be ignored.
std::vector<Counts> count_pairs(const PoseRefinementInput& in, std::span<const PairRecord> pairs,
                                const std::vector<bool>& ignore) {
    std::vector<Counts> out(in.photos.size());
    for (const PairRecord& p : pairs) {
        if (ignore[p.a] || ignore[p.b]) continue;
        for (Counts* c : {&out[p.a], &out[p.b]}) {
            ++c->all;
            c->bad += is_bad(in, p);
            c->contradicting += contradicts(p);
        }
    }
    return out;
}

/// How well photos fit their neighbors with their own camera and with other cameras.
class CameraFits {
  public:
    explicit CameraFits(const PoseRefinementInput& in)
        // More neighbors than were measured are used, in case the nearest ones are misplaced as well.
        : in_(in), near_(photo_pairs(in.photos, in.samples, in.discs, 8)) {}

    /// The best fit to one of a few neighbors of the camera: the fractions of the neighbor's corners that
    /// match the photo's pixels within `near` and within `far_away` of the position predicted by the camera.
    Eigen::Array2d of(std::uint32_t pixels, std::uint32_t camera) {
        const auto [known, is_new] = fits_.emplace(std::pair(pixels, camera), Eigen::Array2d::Zero());
        int tried = 0;
        for (const PhotoPair& p : near_) {
            if (!is_new || tried == max_neighbors) break;
            if (p.a != camera && p.b != camera) continue;
            const std::uint32_t neighbor = p.a == camera ? p.b : p.a;
            if (neighbor == pixels) continue;
            known->second = known->second.max(with(neighbor, pixels, camera));
            ++tried;
        }
        return known->second;
    }

  private:
    Eigen::Array2d with(std::uint32_t neighbor, std::uint32_t pixels, std::uint32_t camera) const {
        const auto from = in_.views.get(neighbor, matched_side);
        MatchView other = *in_.views.get(camera, matched_side);
        other.gray = in_.views.get(pixels, matched_side)->gray;
        SurfaceChart chart(*from, from->pose, neighbor, corners_of_neighbor);
        const std::size_t compared = chart.match(other, other.pose, camera);
        Eigen::Array2d found = Eigen::Array2d::Zero();
        for (const Track& t : chart.tracks())
            for (const Match& m : t.matches) {
                const double moved = m.moved.norm() / longer_side(in_.photos[neighbor]);
                found += Eigen::Array2d(moved <= near, moved <= far_away);
            }
        if (compared < 20) return Eigen::Array2d::Zero();
        return found / double(compared);
    }

    const PoseRefinementInput& in_;
    std::vector<PhotoPair> near_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, Eigen::Array2d> fits_;
};

/// Two photos with each other's cameras.
struct Swap {
    std::uint32_t a, b;
    double fit_a, fit_b;  ///< fit of each photo with the other's camera
    double least() const { return std::min(fit_a, fit_b); }
};

/// Photos with bad pairs, those with the largest fraction of bad pairs first.
std::vector<std::uint32_t> suspects(const PoseRefinementInput& in, std::span<const PairRecord> pairs) {
    const std::vector<Counts> counts = count_pairs(in, pairs, std::vector<bool>(in.photos.size()));
    std::vector<std::uint32_t> out;
    for (std::uint32_t i = 0; i < in.photos.size(); ++i)
        if (counts[i].bad > 0) out.push_back(i);
    std::ranges::stable_sort(out, std::greater{},
                             [&](std::uint32_t i) { return double(counts[i].bad) / double(counts[i].all); });
    out.resize(std::min(out.size(), max_suspects));
    std::ranges::sort(out);
    return out;
}

std::vector<Swap> possible_swaps(const PoseRefinementInput& in, std::span<const std::uint32_t> photos) {
    std::vector<Swap> out;
    if (photos.size() < 2) return out;
    CameraFits fits(in);
    for (std::size_t i = 0; i < photos.size(); ++i)
        for (std::size_t j = i + 1; j < photos.size(); ++j) {
            const std::uint32_t a = photos[i], b = photos[j];
            if (in.photos[a].width != in.photos[b].width || in.photos[a].height != in.photos[b].height)
                continue;
            const Eigen::Array2d fit_a = fits.of(a, b);
            if (!(fit_a >= min_fit).any()) continue;
            const Eigen::Array2d fit_b = fits.of(b, a), as_given = fits.of(a, a).max(fits.of(b, b)),
                                 least = fit_a.min(fit_b);
            if ((least >= min_fit && least >= min_better * as_given).any())
                out.push_back({a, b, fit_a[1], fit_b[1]});
        }
    std::ranges::stable_sort(out, std::greater{}, &Swap::least);
    return out;
}

}  // namespace

MisplacedPhotos misplaced_photos(const PoseRefinementInput& in, std::span<const PairRecord> pairs) {
    MisplacedPhotos out;
    std::vector<bool> reported(in.photos.size());
    for (const Swap& s : possible_swaps(in, suspects(in, pairs))) {
        if (reported[s.a] || reported[s.b]) continue;
        reported[s.a] = reported[s.b] = out.swapped = true;
        out.warnings.push_back(fmt::format(
            "the cameras of {} and {} appear to be swapped: each photo matches its neighbors with the "
            "other's camera ({:.0f} and {:.0f} % of the corners)",
            in.photos[s.a].name, in.photos[s.b].name, 100 * s.fit_a, 100 * s.fit_b));
    }
    if (std::ranges::none_of(pairs, trusted)) return out;
    const std::vector<Counts> others = count_pairs(in, pairs, reported);
    for (std::uint32_t i = 0; i < in.photos.size(); ++i)
        if (!reported[i] && others[i].all > 0 && others[i].contradicting == others[i].all)
            out.warnings.push_back(fmt::format("{} contradicts all photos of the same surface: wrong camera?",
                                               in.photos[i].name));
    return out;
}

}  // namespace vantage
