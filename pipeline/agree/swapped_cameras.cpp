#include "pipeline/agree/swapped_cameras.h"

#include <fmt/format.h>

#include <algorithm>

namespace vantage {
namespace {

using package::PairRecord;

constexpr int long_side = 800, corners = 300;
constexpr double least_fit = 0.4;
constexpr int neighbours_tried = 4;
constexpr std::size_t most_tried = 12;  ///< photos that may have each other's cameras

/// Photos all of whose pairs contradict, although others agree.
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

/// The share of a photo's corners that are found again in `pixels`, taken for what the camera of `camera`
/// saw.
double fit_with(const RegistrationInput& in, std::uint32_t neighbour, std::uint32_t pixels,
                std::uint32_t camera) {
    const MatchView from = read_match_view(in.package, in.photos[neighbour], neighbour, long_side);
    MatchView other = read_match_view(in.package, in.photos[camera], camera, long_side);
    other.grey = read_match_view(in.package, in.photos[pixels], pixels, long_side).grey;
    SurfaceChart chart(from, from.pose, neighbour, corners);
    const std::size_t compared = chart.match(other, other.pose, camera);
    std::size_t found = 0;
    for (const Track& s : chart.tracks()) found += s.matches.size();
    return compared < 20 ? 0 : double(found) / double(compared);
}

/// The best of a few neighbours that are not lost themselves; 0 without any.
double fit(const RegistrationInput& in, std::span<const PhotoPair> pairs, std::span<const std::uint32_t> lost,
           std::uint32_t pixels, std::uint32_t camera) {
    double best = 0;
    int tried = 0;
    for (const PhotoPair& p : pairs) {
        if ((p.a != camera && p.b != camera) || tried == neighbours_tried) continue;
        const std::uint32_t neighbour = p.a == camera ? p.b : p.a;
        if (std::ranges::count(lost, neighbour)) continue;
        best = std::max(best, fit_with(in, neighbour, pixels, camera));
        ++tried;
    }
    return best;
}

}  // namespace

std::vector<std::string> misplaced_photos(const RegistrationInput& in, std::span<const PairRecord> pairs) {
    std::vector<std::uint32_t> lost = lost_photos(in, pairs);
    std::vector<std::string> out;
    // More neighbours than were measured, for those whose nearest are lost, too.
    const std::vector<PhotoPair> near =
        lost.empty() ? std::vector<PhotoPair>{} : photo_pairs(in.photos, in.samples, in.discs, 8);
    std::vector<bool> named(in.photos.size());
    for (std::size_t i = 0; i < std::min(lost.size(), most_tried); ++i)
        for (std::size_t j = i + 1; j < std::min(lost.size(), most_tried) && !named[lost[i]]; ++j) {
            const std::uint32_t a = lost[i], b = lost[j];
            if (named[b] || in.photos[a].width != in.photos[b].width ||
                in.photos[a].height != in.photos[b].height)
                continue;
            const double there = fit(in, near, lost, a, b), back = fit(in, near, lost, b, a);
            if (std::min(there, back) < least_fit) continue;
            named[a] = named[b] = true;
            out.push_back(fmt::format(
                "the cameras of {} and {} are swapped, it seems: each photo fits the other's ({:.0f} "
                "and {:.0f} % of the corners are found again)",
                in.photos[a].name, in.photos[b].name, 100 * there, 100 * back));
        }
    for (const std::uint32_t i : lost)
        if (!named[i])
            out.push_back(
                fmt::format("{} does not show what the others show through the model: is its camera right?",
                            in.photos[i].name));
    return out;
}

}  // namespace vantage
