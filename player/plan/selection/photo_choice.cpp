#include "player/plan/selection/photo_choice.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "player/plan/own_photo.h"
#include "player/plan/selection/photo_cover.h"

namespace vantage {
namespace {

struct Candidate {
    std::uint32_t photo;
    double agreement, rank;
    bool previous;  ///< part of the previous choice
};
constexpr double hysteresis = 1.15;  // factor by which a new photo must be better

std::vector<Candidate> candidates(const VisibleSurface& s, std::span<const std::uint32_t> allowed,
                                  Choice choice, std::span<const std::uint32_t> previous) {
    std::vector<Candidate> out;
    for (const std::uint32_t p : allowed) {
        const double a = agreement(s, p);
        if (!(a > 0)) continue;
        double rank = a;
        if (choice == Choice::nearest) rank = 1 / (1e-12 + (s.scene.poses[p].center() - s.eye).norm());
        const bool chosen_before = std::ranges::count(previous, p) > 0;
        out.push_back({p, a, rank * (chosen_before ? hysteresis : 1), chosen_before});
    }
    std::stable_sort(out.begin(), out.end(), [](const auto& a, const auto& b) { return a.rank > b.rank; });
    return out;
}

/// The set cover of the visible surface: one set per candidate, preferred by rank.
CoverProblem cover_problem(const VisibleSurface& s, const std::vector<Candidate>& candidates) {
    CoverProblem problem;
    const std::size_t step = std::max<std::size_t>(1, s.triangles.size() / 16384);
    for (std::size_t i = 0; i < s.triangles.size(); i += step)
        if (s.triangles[i] >= s.scene.first_triangle_behind())
            continue;
        else if (!problem.runs.empty() && problem.runs.back().first == s.triangles[i])
            ++problem.runs.back().area;
        else
            problem.runs.push_back({s.triangles[i], 1, 1});
    // While the visible triangles are unknown, a sample of the clusters in view is sufficient.
    const std::size_t every = std::max<std::size_t>(1, s.clusters.size() / 128);
    for (std::size_t i = 0; s.triangles.empty() && i < s.clusters.size(); i += every) {
        if (s.clusters[i] >= s.scene.first_surrounding) continue;
        const package::ClusterRecord& c = s.scene.clusters[s.clusters[i]];
        problem.runs.push_back({c.first_triangle, c.triangles, s.areas[i] / c.triangles});
    }
    const std::size_t words = package::visible_words(s.scene.triangles);
    for (const Candidate& c : candidates) {
        const auto bits = s.scene.visible[c.photo];
        // cover() uses the fourth root of a preference; the additional factors of the hysteresis compensate
        // for that.
        const double preference = c.rank * (c.previous ? hysteresis * hysteresis * hysteresis : 1);
        problem.sets.push_back({bits.first(words), bits.subspan(words, words), preference});
    }
    return problem;
}

/// The candidate, if any, taken from the viewer's position. Its picture is the view itself, so complete plans
/// include it even if the cover does not need it.
std::optional<std::size_t> own_candidate(const VisibleSurface& s, const PlanSettings& settings,
                                         std::span<const std::uint32_t> allowed,
                                         const std::vector<Candidate>& among) {
    const auto own = settings.complete ? own_photo(s.scene, s.view, allowed) : std::nullopt;
    const auto at = own ? std::ranges::find(among, *own, &Candidate::photo) : among.end();
    if (at == among.end()) return {};
    return std::size_t(at - among.begin());
}

}  // namespace

PhotoChoice choose_photos(const VisibleSurface& s, const PlanSettings& settings,
                          std::span<const std::uint32_t> allowed, std::span<const std::uint32_t> previous) {
    const std::vector<Candidate> all = candidates(s, allowed, settings.choice, previous);
    const auto wanted = settings.photos > 0 ? std::size_t(settings.photos) : all.size();
    const CoverProblem problem = cover_problem(s, all);
    std::vector<std::size_t> chosen;
    if (settings.choice == Choice::cover && wanted < all.size()) chosen = cover(problem);
    const auto within = [&](const Candidate& c) {
        const double cosine = s.view.cam_from_origin.direction().dot(s.scene.poses[c.photo].direction());
        return settings.angle_limit <= 0 || std::acos(std::clamp(cosine, -1.0, 1.0)) <= settings.angle_limit;
    };
    if (const auto own = own_candidate(s, settings, allowed, all); own && !std::ranges::count(chosen, *own))
        chosen.push_back(*own);
    for (std::size_t i = 0; i < all.size() && chosen.size() < wanted; ++i)
        if (within(all[i]) && !std::ranges::count(chosen, i)) chosen.push_back(i);
    PhotoChoice out{{}, uncovered_share(problem, chosen)};
    for (const std::size_t i : chosen) out.photos.push_back({all[i].photo, all[i].agreement});
    std::ranges::stable_sort(out.photos, std::ranges::greater{}, &ChosenPhoto::agreement);
    return out;
}

}  // namespace vantage
