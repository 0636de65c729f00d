#include "player/plan.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <string>

#include "player/photo_cover.h"
#include "player/shown_tiles.h"
#include "scene/error.h"

namespace vantage {
namespace {

Eigen::Vector3d center(const package::ClusterRecord& c) { return {c.center[0], c.center[1], c.center[2]}; }

/// Angle between the rays from a point to the viewer and to a photo.
double ray_angle(const Eigen::Vector3d& point, const Eigen::Vector3d& eye, const Eigen::Vector3d& photo) {
    const Eigen::Vector3d a = eye - point, b = photo - point;
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Pixels that a cluster's sphere fills, at most the frame.
double area_in_view(const package::ClusterRecord& c, const View& view) {
    const Intrinsics& k = view.intrinsics;
    const double z = (view.cam_from_origin.R * center(c) + view.cam_from_origin.t).z();
    const double reach = std::max(z, double(c.radius)), r = c.radius / reach;
    return std::min(std::numbers::pi * r * r * k.fx * k.fy, double(k.width) * k.height);
}

/// The view with what does not depend on the photos.
struct Sight {
    const PlanScene& scene;
    const View& view;
    Eigen::Vector3d eye;
    std::vector<std::uint32_t> clusters;
    std::vector<double> areas{};           ///< of clusters; any unit, 0: not seen
    std::vector<std::uint32_t> samples{};  ///< triangles seen, with repetitions; none: unknown
    std::vector<bool> shown{};             ///< a cluster: some of it was seen
    /// Some of the samples, as surfaces, with their triangles and clusters.
    struct Surface {
        std::vector<SurfaceSample> samples;
        std::vector<std::uint32_t> triangles, clusters;
        double pixels = 0;  ///< of the view, that one of them stands for
    } surface{};
};

/// The cluster of each sample, and where it is none of the model's triangles, 2^32 - 1.
std::vector<std::uint32_t> clusters_of(const PlanScene& scene, std::span<const std::uint32_t> seen) {
    const auto holds = [&](std::size_t c, std::uint32_t t) {
        return t - scene.clusters[c].first_triangle < scene.clusters[c].triangles;
    };
    std::vector<std::uint32_t> out(seen.size(), ~0u);
    std::size_t cluster = 0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const std::uint32_t t = seen[i] - 1;
        if (seen[i] == 0 || t >= scene.triangles) continue;
        if (!holds(cluster, t))  // neighbours are mostly of one cluster
            cluster = std::size_t(
                std::ranges::upper_bound(scene.clusters, t, {}, &package::ClusterRecord::first_triangle) -
                scene.clusters.begin() - 1);
        out[i] = std::uint32_t(cluster);
    }
    return out;
}

bool sees(std::span<const std::uint64_t> visible, std::size_t triangles, std::uint32_t t) {
    return visible[package::visible_words(triangles) + t / 64] >> (t % 64) & 1;
}

/// Points of the triangles, spread over each by the plastic ratio's sequence (Roberts 2018).
Sight::Surface surface_of(const PlanScene& scene, const View& view, std::span<const std::uint32_t> triangles,
                          std::span<const std::uint32_t> clusters, std::size_t seen, double samples) {
    constexpr std::size_t most = 8192;
    Sight::Surface out;
    const std::size_t step = std::max<std::size_t>(1, triangles.size() / most);
    for (std::size_t i = 0; i < triangles.size(); i += step) {
        Eigen::Vector3d corner[3];
        for (std::size_t v = 0; v < 3; ++v)
            corner[v] = scene.positions[scene.indices[3 * std::size_t(triangles[i]) + v]].cast<double>();
        double a = std::fmod(double(i) * 0.7548776662466927, 1.0),
               b = std::fmod(double(i) * 0.5698402909980532, 1.0);
        if (a + b > 1) a = 1 - a, b = 1 - b;
        const Eigen::Vector3d e = corner[1] - corner[0], f = corner[2] - corner[0];
        const auto s = surface_sample(view, corner[0] + a * e + b * f, e.cross(f).normalized(), samples);
        if (!s) continue;
        out.samples.push_back(*s);
        out.triangles.push_back(triangles[i]);
        out.clusters.push_back(clusters[i]);
    }
    if (seen > 0)
        out.pixels = double(view.intrinsics.width) * view.intrinsics.height / double(seen) * double(step) *
                     samples * samples;
    return out;
}

Sight look(const PlanScene& scene, const View& view, std::span<const std::uint32_t> seen, double samples) {
    Sight s{scene, view, view.cam_from_origin.center(), clusters_in_view(scene.tree, scene.clusters, view)};
    const std::vector<std::uint32_t> all = clusters_of(scene, seen);
    std::vector<std::uint32_t> count(scene.clusters.size(), 0), clusters;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        if (all[i] == ~0u) continue;
        ++count[all[i]];
        s.samples.push_back(seen[i] - 1);
        clusters.push_back(all[i]);
    }
    s.surface = surface_of(scene, view, s.samples, clusters, seen.size(), samples);
    for (const std::uint32_t n : count) s.shown.push_back(n > 0);
    for (const std::uint32_t c : s.clusters)
        s.areas.push_back(s.samples.empty() ? area_in_view(scene.clusters[c], view) : count[c]);
    return s;
}

/// The tiles of one photo for those of its clusters that are, or are not, shown; all count as shown where
/// that is not known.
TileNeeds needs_of_clusters(const Sight& s, const PlannedPhoto& p, bool shown, double samples) {
    std::vector<ClusterLevels> levels;
    const Intrinsics& k = s.scene.intrinsics[p.photo];
    for (const std::uint32_t c : p.clusters)
        if ((s.samples.empty() || s.shown[c]) == shown)
            levels.push_back(
                {c, sampled_levels(s.scene.clusters[c], k, s.scene.poses[p.photo], s.view, samples)});
    return tile_needs(s.scene.photos[p.photo], s.scene.coverage[p.photo], levels);
}

/// What is lost with a level is some grey levels of detail: an eighth of them cannot be told, a 32nd of two
/// levels' not either.
double spared_levels(double weight) { return std::clamp(-std::log2(8 * weight) / 2, 0.0, 2.0); }

/// The tiles of one photo that are worth having for what is seen.
TileNeeds needs_of_samples(const Sight& s, const PlannedPhoto& p, double worth) {
    std::vector<float> weights(s.scene.clusters.size(), 0);
    for (std::size_t i = 0; i < p.clusters.size(); ++i) weights[p.clusters[i]] = p.weights[i];
    std::vector<SurfaceSample> samples;
    for (std::size_t i = 0; i < s.surface.samples.size(); ++i) {
        const float weight = weights[s.surface.clusters[i]];
        if (!(weight > 0) || !sees(s.scene.visible[p.photo], s.scene.triangles, s.surface.triangles[i]))
            continue;
        samples.push_back(s.surface.samples[i]);
        samples.back().coarser = spared_levels(weight);
    }
    return shown_tiles(s.scene.photos[p.photo], s.scene.intrinsics[p.photo], s.scene.poses[p.photo], samples,
                       s.surface.pixels, worth);
}

/// Whether a photo can show this side of a cluster: one that looks away from the viewer is shown by photos
/// that it looks away from, too.
bool same_side(const package::ClusterRecord& c, bool away, const Eigen::Vector3d& photo) {
    return !away || looks_away(c, photo);
}

constexpr double agreement_angle = 0.35;  ///< radians; wider than the blend's, to rank the far ones, too

/// Over at most 512 clusters, evenly drawn from all in view: a rank needs no more.
double agreement(const Sight& s, std::uint32_t photo) {
    const auto& coverage = s.scene.coverage[photo];
    if (coverage.empty()) return 0;
    const Eigen::Vector3d from = s.scene.poses[photo].center();
    const std::size_t step = std::max<std::size_t>(1, s.clusters.size() / 512);
    double agrees = 0, all = 0;
    for (std::size_t i = 0; i < s.clusters.size(); i += step) {
        const std::uint32_t c = s.clusters[i];
        if (s.areas[i] == 0) continue;
        all += s.areas[i];
        if (coverage[c].seen == 0) continue;
        agrees += s.areas[i] * coverage[c].seen / 65535.0 *
                  std::exp(-ray_angle(center(s.scene.clusters[c]), s.eye, from) / agreement_angle);
    }
    return all > 0 ? agrees / all : 0;
}

bool contains(std::span<const std::uint32_t> list, std::uint32_t value) {
    return std::find(list.begin(), list.end(), value) != list.end();
}

struct Candidate {
    std::uint32_t photo;
    double agreement, rank;
};

std::vector<Candidate> candidates(const Sight& s, std::span<const std::uint32_t> allowed, Choice choice,
                                  std::span<const std::uint32_t> previous) {
    constexpr double loyalty = 1.15;  // a newcomer must be better by this much
    std::vector<Candidate> out;
    for (const std::uint32_t p : allowed) {
        const double a = agreement(s, p);
        if (!(a > 0)) continue;
        double rank = a;
        if (choice == Choice::nearest)
            rank = 1 / (1e-12 + (s.scene.poses[p].center() - s.eye).norm());
        else if (choice == Choice::direction)
            rank = std::max(1e-3, s.view.cam_from_origin.direction().dot(Eigen::Map<const Eigen::Vector3d>(
                                      s.scene.photos[p].corrected_direction))) *
                   std::max(0.01, s.scene.photos[p].hull_area);
        out.push_back({p, a, rank * (contains(previous, p) ? loyalty : 1)});
    }
    std::stable_sort(out.begin(), out.end(), [](const auto& a, const auto& b) { return a.rank > b.rank; });
    return out;
}

/// For the set cover: what each candidate adds, weighed by how well it agrees.
CoverProblem cover_problem(const Sight& s, const std::vector<Candidate>& candidates) {
    CoverProblem problem;
    const std::size_t step = std::max<std::size_t>(1, s.samples.size() / 16384);
    for (std::size_t i = 0; i < s.samples.size(); i += step)
        if (!problem.runs.empty() && problem.runs.back().first == s.samples[i])
            ++problem.runs.back().area;
        else
            problem.runs.push_back({s.samples[i], 1, 1});
    for (std::size_t i = 0; s.samples.empty() && i < s.clusters.size(); ++i) {
        const package::ClusterRecord& c = s.scene.clusters[s.clusters[i]];
        problem.runs.push_back({c.first_triangle, c.triangles, s.areas[i] / c.triangles});
    }
    const std::size_t words = package::visible_words(s.scene.triangles);
    for (const Candidate& c : candidates) {
        const auto bits = s.scene.visible[c.photo];
        problem.sets.push_back({bits.first(words), bits.subspan(words, words), c.rank});
    }
    return problem;
}

std::vector<Candidate> choose(const Sight& s, const PlanSettings& settings, std::vector<Candidate> all,
                              double& uncovered) {
    const auto wanted = settings.photos > 0 ? std::size_t(settings.photos) : all.size();
    const CoverProblem problem = cover_problem(s, all);
    std::vector<std::size_t> chosen;
    if (settings.choice == Choice::cover && wanted < all.size()) chosen = cover(problem);
    const auto within = [&](const Candidate& c) {
        const double cosine = s.view.cam_from_origin.direction().dot(s.scene.poses[c.photo].direction());
        return settings.angle_limit <= 0 || std::acos(std::clamp(cosine, -1.0, 1.0)) <= settings.angle_limit;
    };
    for (std::size_t i = 0; i < all.size() && chosen.size() < wanted; ++i)
        if (within(all[i]) && std::find(chosen.begin(), chosen.end(), i) == chosen.end()) chosen.push_back(i);
    uncovered = uncovered_share(problem, chosen);
    std::vector<Candidate> out;
    for (const std::size_t i : chosen) out.push_back(all[i]);
    std::stable_sort(out.begin(), out.end(),
                     [](const auto& a, const auto& b) { return a.agreement > b.agreement; });
    return out;
}

/// Which of the chosen photos draw which clusters: all that see them, but for those whose weight next to a
/// photo that sees the whole cluster could not change a colour code.
void assign_clusters(const Sight& s, const PlanSettings& settings, std::vector<PlannedPhoto>& photos) {
    constexpr double least = 1.0 / 1024;
    const std::size_t words = package::visible_words(s.scene.triangles);
    std::vector<Eigen::Vector3d> centers;
    for (const PlannedPhoto& p : photos) centers.push_back(s.scene.poses[p.photo].center());
    std::vector<double> weights(photos.size());
    for (const std::uint32_t index : s.clusters) {
        const package::ClusterRecord& c = s.scene.clusters[index];
        const bool away = looks_away(c, s.eye);
        double best = 0;
        for (std::size_t i = 0; i < photos.size(); ++i) {
            weights[i] = -1;
            const std::uint32_t p = photos[i].photo;
            if (s.scene.coverage[p][index].seen == 0 || !same_side(c, away, centers[i])) continue;
            // The angle may be smaller elsewhere in the cluster, or that of the best one larger.
            const double turn =
                c.radius * std::abs(1 / (center(c) - s.eye).norm() - 1 / (center(c) - centers[i]).norm());
            const double theta = std::max(0.0, ray_angle(center(c), s.eye, centers[i]) - turn),
                         density = std::exp2(s.scene.coverage[p][index].log2_density / 128.0);
            weights[i] = settings.sharpness > 0 ? std::exp(-theta / settings.sharpness) * density : 1;
            if (count_bits(s.scene.visible[p].first(words), c.first_triangle, c.triangles) == c.triangles)
                best = std::max(best, weights[i]);
        }
        for (std::size_t i = 0; i < photos.size(); ++i)
            if (weights[i] >= 0 && weights[i] >= least * best) {
                photos[i].clusters.push_back(index);
                photos[i].weights.push_back(best > 0 ? float(std::min(1.0, weights[i] / best)) : 1.0f);
            }
    }
}

}  // namespace

PlanScene make_plan_scene(const PackageReader& package) {
    using package::Type;
    const package::SceneRecord& record = package.scene();
    PlanScene s;
    s.photos = package.photos();
    s.clusters = package.records<package::ClusterRecord>(Type::clusters);
    s.tree = make_cluster_tree(s.clusters);
    s.triangles = record.triangles;
    s.positions = package.records<Eigen::Vector3f>(Type::positions);
    s.indices = package.records<std::uint32_t>(Type::indices);
    for (std::uint32_t i = 0; i < s.photos.size(); ++i) {
        s.intrinsics.push_back(intrinsics(s.photos[i]));
        s.poses.push_back(cam_from_origin(s.photos[i]));
        s.coverage.emplace_back();
        s.visible.emplace_back();
        if (!s.photos[i].levels) continue;
        s.coverage.back() = package.records<package::CoverageRecord>(Type::coverage, i);
        s.visible.back() = package.records<std::uint64_t>(Type::visible, i);
        if (s.coverage.back().size() != s.clusters.size() ||
            s.visible.back().size() != 2 * package::visible_words(s.triangles))
            throw Error(Exit::damaged, package.path().string() + ": COVR or VISB of " +
                                           std::string(s.photos[i].name) +
                                           ": length does not fit the scene's counts");
    }
    return s;
}

Plan make_plan(const PlanScene& scene, const View& view, const PlanSettings& settings,
               std::span<const std::uint32_t> allowed, std::span<const std::uint32_t> previous,
               std::span<const std::uint32_t> seen) {
    Sight sight = look(scene, view, seen, settings.samples);
    Plan plan;
    for (const Candidate& c :
         choose(sight, settings, candidates(sight, allowed, settings.choice, previous), plan.uncovered))
        plan.photos.push_back({c.photo, c.agreement, {}, {}, {}, {}});
    assign_clusters(sight, settings, plan.photos);
    for (PlannedPhoto& p : plan.photos) {
        const bool by_samples = settings.worth > 0 && !sight.samples.empty();
        p.needs = by_samples ? needs_of_samples(sight, p, settings.worth)
                             : needs_of_clusters(sight, p, true, settings.samples);
        p.later = needs_of_clusters(sight, p, false, settings.samples);
    }
    std::erase_if(plan.photos, [](const PlannedPhoto& p) { return p.clusters.empty(); });
    plan.clusters = std::move(sight.clusters);
    return plan;
}

std::vector<double> agreements(const PlanScene& scene, const View& view) {
    const Sight sight = look(scene, view, {}, 1);
    std::vector<double> out;
    for (std::uint32_t p = 0; p < scene.photos.size(); ++p) out.push_back(agreement(sight, p));
    return out;
}

}  // namespace vantage
