#include "pipeline/refine/poses/pair_matching.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>

#include "base/values/quantile.h"
#include "pipeline/run/for_each_photo.h"

namespace vantage {
namespace {

constexpr std::uint32_t min_matches = 20;

std::int16_t in_64ths(double pixels) {
    return std::int16_t(std::clamp(std::lround(64 * pixels), -32767l, 32767l));
}

/// The displacements of one pair of photos, overall and per cell of the first photo.
class Displacements {
  public:
    Displacements(std::span<const Track> tracks, std::uint32_t other, const Intrinsics& k) {
        for (const Track& s : tracks)
            for (const Match& m : s.matches)
                if (m.photo == other) {
                    all_.add(m.moved);
                    cells_[cell(s.pixel, k)].add(m.moved);
                }
    }
    void summarize(package::PairRecord& r) const {
        r.matches = std::uint32_t(all_.x.size());
        r.median = float(quantile(all_.length, 0.5));
        r.p90 = float(quantile(all_.length, 0.9));
        r.shift[0] = float(quantile(all_.x, 0.5));
        r.shift[1] = float(quantile(all_.y, 0.5));
        for (std::size_t c = 0; c < cells_.size(); ++c)
            r.cells[c] = {{in_64ths(quantile(cells_[c].x, 0.5)), in_64ths(quantile(cells_[c].y, 0.5))},
                          std::uint16_t(cells_[c].x.size())};
    }

  private:
    struct List {
        std::vector<double> x, y, length;
        void add(const Eigen::Vector2d& d) {
            x.push_back(d.x());
            y.push_back(d.y());
            length.push_back(d.norm());
        }
    };
    static std::size_t cell(const Eigen::Vector2d& pixel, const Intrinsics& k) {
        const int column = std::clamp(int(pixel.x() * package::pair_columns / k.width), 0,
                                      package::pair_columns - 1),
                  row = std::clamp(int(pixel.y() * package::pair_rows / k.height), 0, package::pair_rows - 1);
        return std::size_t(row * package::pair_columns + column);
    }
    List all_;
    std::array<List, package::pair_columns * package::pair_rows> cells_;
};

package::PairRecord record_of(const PhotoPair& p) {
    package::PairRecord r{};
    r.a = p.a;
    r.b = p.b;
    r.shared = p.shared;
    r.angle = float(p.angle);
    r.color = float(p.color);
    return r;
}

template <class Wanted>
double median_of(std::span<const package::PairRecord> pairs, const Wanted& wanted) {
    std::vector<double> medians;
    for (const package::PairRecord& p : pairs)
        if (trusted(p) && wanted(p)) medians.push_back(double(p.median));
    return quantile(std::move(medians), 0.5);
}

}  // namespace

Matching match_pairs(const MatchViews& views, std::span<const package::PhotoRecord> photos,
                     std::span<const Pose> poses, std::span<const PhotoPair> pairs,
                     const MatchSettings& how) {
    Matching out;
    std::vector<std::pair<std::size_t, std::size_t>> groups;  // ranges of pairs with the same first photo
    for (std::size_t p = 0; p < pairs.size(); ++p) {
        out.pairs.push_back(record_of(pairs[p]));
        if (groups.empty() || pairs[groups.back().first].a != pairs[p].a) groups.emplace_back(p, p);
        groups.back().second = p + 1;
    }
    std::vector<std::vector<Track>> tracks(groups.size());
    std::mutex mutex;
    std::size_t done = 0;
    if (how.progress && !groups.empty()) how.progress({"match", "", 0, groups.size()});
    for_each_photo(groups.size(), how.threads, [&](std::size_t c) {
        const std::uint32_t a = pairs[groups[c].first].a;
        const auto own = views.get(a, how.long_side);
        SurfaceChart chart(*own, poses[a], a, how.corners);
        for (std::size_t p = groups[c].first; p < groups[c].second; ++p) {
            const std::uint32_t b = pairs[p].b;
            out.pairs[p].corners = std::uint32_t(chart.match(*views.get(b, how.long_side), poses[b], b));
            Displacements(chart.tracks(), b, intrinsics(photos[a])).summarize(out.pairs[p]);
        }
        tracks[c] = chart.tracks();
        std::erase_if(tracks[c], [](const Track& s) { return s.matches.empty(); });
        views.package().forget_all();
        const std::scoped_lock lock(mutex);
        if (how.progress) how.progress({"match", photos[a].name, ++done, groups.size()});
    });
    for (std::vector<Track>& s : tracks) out.tracks.insert(out.tracks.end(), s.begin(), s.end());
    return out;
}

bool trusted(const package::PairRecord& p) { return p.matches >= min_matches && !contradicts(p); }

bool contradicts(const package::PairRecord& p) {
    return p.corners >= min_matches && 4 * p.matches < p.corners;
}

double median_displacement(std::span<const package::PairRecord> pairs) {
    return median_of(pairs, [](const package::PairRecord&) { return true; });
}

double median_displacement(std::span<const package::PairRecord> pairs, std::uint32_t photo) {
    return median_of(pairs, [&](const package::PairRecord& p) { return p.a == photo || p.b == photo; });
}

double median_displacement_without(std::span<const package::PairRecord> pairs, std::uint32_t photo) {
    return median_of(pairs, [&](const package::PairRecord& p) { return p.a != photo && p.b != photo; });
}

}  // namespace vantage
