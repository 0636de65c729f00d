#include "pipeline/agree/swapped_cameras.h"

#include <fmt/format.h>

#include <algorithm>

namespace vantage {
namespace {

using package::PairRecord;

constexpr int long_side = 800, corners = 300;
constexpr double min_fit = 0.4;  ///< share of the corners
constexpr int max_neighbors = 4;
constexpr std::size_t max_tried = 12;  ///< photos tried with each other's cameras

/// Photos whose pairs all contradict; none if no pair at all is trusted.
std::vector<std::uint32_t> lost_photos(const RegistrationInput& in, std::span<const PairRecord> pairs) {
    std::vector<std::uint32_t> lost;
    if (std::ranges::none_of(pairs, trusted)) return lost;
    for (std::uint32_t i = 0; i < in.photos.size(); ++i) {
        std::size_t against = 0, with = 0;
        for (const PairRecord& p : pairs)
            if (p.a == i || p.b == i) ++(contradicts(p) ? against : with);
        if (against > 0 && with == 0) lost.push_back(i);
    }
    return lost;
}

/// The share of a neighbor's corners that match the pixels of one photo seen with the camera of another.
double fit_with(const RegistrationInput& in, std::uint32_t neighbor, std::uint32_t pixels,
                std::uint32_t camera) {
    const MatchView from = read_match_view(in.package, in.photos[neighbor], neighbor, long_side);
    MatchView other = read_match_view(in.package, in.photos[camera], camera, long_side);
    other.gray = read_match_view(in.package, in.photos[pixels], pixels, long_side).gray;
    SurfaceChart chart(from, from.pose, neighbor, corners);
    const std::size_t compared = chart.match(other, other.pose, camera);
    std::size_t found = 0;
    for (const Track& s : chart.tracks()) found += s.matches.size();
    return compared < 20 ? 0 : double(found) / double(compared);
}

/// The best fit over a few neighbors that are not lost themselves; 0 if there are none.
double fit(const RegistrationInput& in, std::span<const PhotoPair> pairs, std::span<const std::uint32_t> lost,
           std::uint32_t pixels, std::uint32_t camera) {
    double best = 0;
    int tried = 0;
    for (const PhotoPair& p : pairs) {
        if ((p.a != camera && p.b != camera) || tried == max_neighbors) continue;
        const std::uint32_t neighbor = p.a == camera ? p.b : p.a;
        if (std::ranges::count(lost, neighbor)) continue;
        best = std::max(best, fit_with(in, neighbor, pixels, camera));
        ++tried;
    }
    return best;
}

}  // namespace

std::vector<std::string> misplaced_photos(const RegistrationInput& in, std::span<const PairRecord> pairs) {
    std::vector<std::uint32_t> lost = lost_photos(in, pairs);
    std::vector<std::string> out;
    // More neighbors than were measured, in case the nearest ones are lost as well.
    const std::vector<PhotoPair> near =
        lost.empty() ? std::vector<PhotoPair>{} : photo_pairs(in.photos, in.samples, in.discs, 8);
    std::vector<bool> reported(in.photos.size());
    for (std::size_t i = 0; i < std::min(lost.size(), max_tried); ++i)
        for (std::size_t j = i + 1; j < std::min(lost.size(), max_tried) && !reported[lost[i]]; ++j) {
            const std::uint32_t a = lost[i], b = lost[j];
            if (reported[b] || in.photos[a].width != in.photos[b].width ||
                in.photos[a].height != in.photos[b].height)
                continue;
            const double fit_a = fit(in, near, lost, a, b), fit_b = fit(in, near, lost, b, a);
            if (std::min(fit_a, fit_b) < min_fit) continue;
            reported[a] = reported[b] = true;
            out.push_back(fmt::format(
                "the cameras of {} and {} appear to be swapped: each photo matches its neighbors with the "
                "other's camera ({:.0f} and {:.0f} % of the corners)",
                in.photos[a].name, in.photos[b].name, 100 * fit_a, 100 * fit_b));
        }
    for (const std::uint32_t i : lost)
        if (!reported[i])
            out.push_back(fmt::format("{} contradicts all photos of the same surface: wrong camera?",
                                      in.photos[i].name));
    return out;
}

}  // namespace vantage
