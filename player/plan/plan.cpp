#include "player/plan/plan.h"

#include <algorithm>
#include <cmath>

#include "player/plan/background_photos.h"
#include "player/plan/selection/photo_choice.h"
#include "player/plan/selection/photo_cover.h"

namespace vantage {
namespace {

/// Whether a photo sees the same side of a cluster as the viewer: if the cluster faces away from the viewer,
/// it must face away from the photo, too.
bool same_side(const package::ClusterRecord& c, bool away, const Eigen::Vector3d& photo) {
    return !away || faces_away(c, photo);
}

/// Assigns each cluster to the chosen photos that see it. With `worth`, omits photos whose weight relative to
/// a photo that sees the whole cluster is below 1/1024, less than one color code: they would show only where
/// the other photo's weight maps are 0. A reduced plan has only photos that weigh much.
void assign_clusters(const VisibleSurface& s, const PlanSettings& settings,
                     std::vector<PlannedPhoto>& photos) {
    const double least = !(settings.worth > 0) ? 0 : settings.reduced ? 0.3 : 1.0 / 1024;
    const std::size_t words = package::visible_words(s.scene.triangles);
    std::vector<Eigen::Vector3d> centers;
    for (const PlannedPhoto& p : photos) centers.push_back(s.scene.poses[p.photo].center());
    std::vector<double> weights(photos.size());
    for (const std::uint32_t index : s.clusters) {
        if (index >= s.scene.first_surrounding) continue;
        const package::ClusterRecord& c = s.scene.clusters[index];
        const bool away = faces_away(c, s.eye);
        // Samples of the picture per unit of the surface.
        const double wanted =
            settings.samples * s.view.intrinsics.fx / std::max((center(c) - s.eye).norm(), 1e-30);
        double best = 0;
        for (std::size_t i = 0; i < photos.size(); ++i) {
            weights[i] = -1;
            const std::uint32_t p = photos[i].photo;
            if (s.scene.coverage[p][index].seen == 0 || !same_side(c, away, centers[i])) continue;
            // The angle may be smaller elsewhere in the cluster, or the best photo's larger.
            const double turn =
                c.radius * std::abs(1 / (center(c) - s.eye).norm() - 1 / (center(c) - centers[i]).norm());
            const double theta = std::max(0.0, ray_angle(center(c), s.eye, centers[i]) - turn),
                         rate = std::exp2(s.scene.coverage[p][index].log2_density / 256.0) / wanted;
            weights[i] =
                settings.sharpness > 0 ? std::exp(-theta / settings.sharpness) * std::min(rate, 1.0) : 1;
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

Plan make_plan(const PlanScene& scene, const View& view, const PlanSettings& settings,
               std::span<const std::uint32_t> allowed, const PlanContext& context) {
    VisibleSurface surface = visible_surface(scene, view, context.seen, settings);
    Plan plan;
    plan.choice =
        context.chosen ? *context.chosen : choose_photos(surface, settings, allowed, context.previous);
    plan.uncovered = plan.choice.uncovered;
    for (const ChosenPhoto& c : plan.choice.photos)
        plan.photos.push_back({c.photo, c.agreement, {}, {}, {}});
    assign_clusters(surface, settings, plan.photos);
    std::vector<float> weights(scene.clusters.size());
    for (PlannedPhoto& p : plan.photos) {
        if (!settings.tiles) break;
        std::ranges::fill(weights, 0.0f);
        for (std::size_t i = 0; i < p.clusters.size(); ++i) weights[p.clusters[i]] = p.weights[i];
        add_needs(p, surface, settings, [&](std::size_t i) {
            return sees(scene, p.photo, surface.points.triangles[i]) ? weights[surface.points.clusters[i]]
                                                                     : 0.0f;
        });
    }
    std::erase_if(plan.photos, [](const PlannedPhoto& p) { return p.clusters.empty(); });
    plan.behind = plan_background(surface, settings, allowed);
    plan.clusters = std::move(surface.clusters);
    plan.transparent = std::move(surface.transparent);
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
