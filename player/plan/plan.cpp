#include "player/plan/plan.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "player/plan/background_photos.h"
#include "player/plan/own_photo.h"
#include "player/plan/selection/photo_choice.h"
#include "player/plan/selection/photo_cover.h"
#include "shaders/contract.h"

namespace vantage {
namespace {

struct CameraOfPhoto {
    std::uint32_t photo;
    Eigen::Vector3d center;
};

/// Whether a photo sees the same side of a cluster as the viewer: if the cluster faces away from the viewer,
/// it must face away from the photo, too.
bool same_side(const package::ClusterRecord& c, bool away, const Eigen::Vector3d& photo) {
    return !away || faces_away(c, photo);
}

/// The largest and the smallest weight of a photo in a cluster, where the cluster is visible and far from
/// borders (shaders/blend.frag). Each weight is given with and without the factor that applies near the
/// photo's own camera.
struct WeightRange {
    double most = 1, least = 1, most_plain = 1, least_plain = 1;
};
WeightRange weight_range(const VisibleSurface& s, const PlanSettings& settings, std::uint32_t cluster,
                         const CameraOfPhoto& camera) {
    if (!(settings.sharpness > 0)) return {};
    const package::ClusterRecord& c = s.scene.clusters[cluster];
    const double distance = std::max((center(c) - s.eye).norm(), 1e-30);
    const double theta = ray_angle(center(c), s.eye, camera.center),
                 turn = c.radius * std::abs(1 / distance - 1 / (center(c) - camera.center).norm());
    // Samples of the picture per scene unit on the surface.
    const double wanted = settings.samples * s.view.intrinsics.fx / distance;
    const double rate =
        std::min(std::exp2(s.scene.coverage[camera.photo][cluster].log2_density / 256.0) / wanted, 1.0);
    const double nearest = std::max(0.0, theta - turn), farthest = theta + turn;
    const auto plain = [&](double angle) { return rate * std::exp(-angle / settings.sharpness); };
    const auto factor = [&](double angle) {
        const double own = shader::own_angle / std::max(angle, double(shader::own_least));
        return settings.own_views ? 1 + own * own : 1;
    };
    const double most = plain(nearest), least = plain(farthest);
    return {most * factor(nearest), least * factor(farthest), most, least};
}

/// For each cluster, whether a photo sees at least a part of each visible triangle.
std::vector<bool> sees_all_seen(const VisibleSurface& s, std::uint32_t photo) {
    std::vector<bool> out(s.scene.clusters.size(), !s.triangles.empty());
    for (std::size_t i = 0; i < s.triangles.size(); ++i)
        if (!sees(s.scene, photo, s.triangles[i])) out[s.clusters_of_triangles[i]] = false;
    return out;
}

/// The chosen photos, and related data.
struct Candidates {
    std::vector<CameraOfPhoto> cameras;
    std::optional<std::size_t> own;  ///< see own_photo()
    std::vector<bool> own_sees;      ///< per cluster: whether `own` sees all visible triangles
};

Candidates candidates_of(const VisibleSurface& s, const PlanSettings& settings,
                         const std::vector<PlannedPhoto>& photos) {
    Candidates out;
    for (const PlannedPhoto& p : photos) out.cameras.push_back({p.photo, s.scene.poses[p.photo].center()});
    if (!settings.own_views || s.triangles.empty()) return out;
    const std::vector<std::uint32_t> numbers = numbers_of(photos);
    const std::optional<std::uint32_t> own = own_photo(s.scene, s.view, numbers);
    if (!own) return out;
    out.own = std::size_t(std::ranges::find(numbers, *own) - numbers.begin());
    out.own_sees = sees_all_seen(s, *own);
    return out;
}

/// Assigns each cluster to the chosen photos that see it. Skips photos whose weight relative to a photo that
/// sees the whole cluster is below one color level: they would be visible only where the other photo's weight
/// maps are 0. If the viewer is at the other photo's camera, that photo's weight is even larger. Photos that
/// are negligible only because of this increase are not skipped; they appear along the borders of the other
/// photo. A reduced plan has only photos with large weights.
void assign_clusters(const VisibleSurface& s, const PlanSettings& settings, const Candidates& candidates,
                     std::vector<PlannedPhoto>& photos) {
    const double least = settings.reduced ? 0.3 : 1.0 / 256, least_own = 1e-5;
    const std::size_t words = package::visible_words(s.scene.triangles);
    std::vector<WeightRange> ranges(photos.size());
    for (const std::uint32_t index : s.clusters) {
        if (index >= s.scene.first_surrounding) continue;
        const package::ClusterRecord& c = s.scene.clusters[index];
        const bool away = faces_away(c, s.eye);
        double best = 0, best_plain = 0;
        for (std::size_t i = 0; i < photos.size(); ++i) {
            ranges[i].most = -1;
            const CameraOfPhoto& camera = candidates.cameras[i];
            if (s.scene.coverage[camera.photo][index].seen == 0 || !same_side(c, away, camera.center))
                continue;
            const WeightRange range = ranges[i] = weight_range(s, settings, index, camera);
            const auto sees_it = [&] {
                return (candidates.own == i && candidates.own_sees[index]) ||
                       count_bits(s.scene.visible[camera.photo].first(words), c.first_triangle,
                                  c.triangles) == c.triangles;
            };
            if ((range.least > best || range.least_plain > best_plain) && sees_it()) {
                best = std::max(best, range.least);
                best_plain = std::max(best_plain, range.least_plain);
            }
        }
        for (std::size_t i = 0; i < photos.size(); ++i) {
            const WeightRange& range = ranges[i];
            if (range.most < 0 || range.most < least_own * best || range.most_plain < least * best_plain)
                continue;
            photos[i].clusters.push_back(index);
            photos[i].weights.push_back(best > 0 ? float(std::min(1.0, range.most / best)) : 1.0f);
        }
    }
}

/// Lists the tiles that the photos need for their clusters. If the viewer is at a photo's camera, lists only
/// that photo's tiles for the surfaces that it sees.
void list_tiles(const VisibleSurface& s, const PlanSettings& settings, const Candidates& candidates,
                std::vector<PlannedPhoto>& photos) {
    std::vector<float> weights(s.scene.clusters.size());
    for (std::size_t i = 0; i < photos.size(); ++i) {
        PlannedPhoto& p = photos[i];
        std::ranges::fill(weights, 0.0f);
        for (std::size_t c = 0; c < p.clusters.size(); ++c) weights[p.clusters[c]] = p.weights[c];
        add_needs(p, s, settings, [&](std::size_t point) {
            const std::uint32_t triangle = s.points.triangles[point];
            if (!sees(s.scene, p.photo, triangle)) return 0.0f;
            const bool owned = candidates.own && candidates.own != i &&
                               sees(s.scene, candidates.cameras[*candidates.own].photo, triangle);
            return owned ? 0.0f : weights[s.points.clusters[point]];
        });
    }
}

}  // namespace

Plan make_plan(const PlanScene& scene, const View& view, const PlanSettings& settings,
               std::span<const std::uint32_t> allowed, const PlanContext& context) {
    VisibleSurface surface = visible_surface(scene, view, context.seen, settings);
    Plan plan;
    plan.choice =
        context.chosen ? *context.chosen : choose_photos(surface, settings, allowed, context.previous);
    plan.uncovered = plan.choice.uncovered;
    for (const ChosenPhoto& c : plan.choice.photos) plan.photos.push_back({c.photo, c.agreement, {}, {}, {}});
    const Candidates candidates = candidates_of(surface, settings, plan.photos);
    assign_clusters(surface, settings, candidates, plan.photos);
    if (settings.tiles) list_tiles(surface, settings, candidates, plan.photos);
    std::erase_if(plan.photos, [](const PlannedPhoto& p) { return p.clusters.empty(); });
    plan.behind = plan_background(surface, settings, allowed);
    plan.clusters = std::move(surface.clusters);
    return plan;
}

std::vector<double> agreements(const PlanScene& scene, const View& view) {
    PlanSettings settings;
    settings.background = false;
    const VisibleSurface surface = visible_surface(scene, view, {}, settings);
    std::vector<double> out;
    for (std::uint32_t p = 0; p < scene.photos.size(); ++p) out.push_back(agreement(surface, p));
    return out;
}

}  // namespace vantage
