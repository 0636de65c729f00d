#include "player/plan/plan.h"

#include <algorithm>
#include <cmath>

#include "player/plan/selection/photo_choice.h"
#include "player/plan/selection/photo_cover.h"
#include "player/plan/selection/shown_tiles.h"
#include "shaders/contract.h"

namespace vantage {
namespace {

/// The tiles of one photo for its clusters that are seen (`seen`) or not seen (otherwise). While visibility
/// is unknown, all clusters count as seen.
TileNeeds needs_of_clusters(const VisibleSurface& s, const PlannedPhoto& p, bool seen, double samples) {
    std::vector<ClusterLevels> levels;
    const Intrinsics& k = s.scene.intrinsics[p.photo];
    for (const std::uint32_t c : p.clusters)
        if ((s.triangles.empty() || s.seen[c]) == seen)
            levels.push_back(
                {c, sampled_levels(s.scene.clusters[c], k, s.scene.poses[p.photo], s.view, samples)});
    return tile_needs(s.scene.photos[p.photo], s.scene.lenses.of(p.photo), s.scene.coverage[p.photo], levels);
}

/// Levels of detail that a photo of this weight may lack. A level holds a few gray levels of detail: at a
/// weight of 1/32 the loss of one is invisible, and at 1/128 that of two.
double spared_levels(double weight) { return std::clamp(-std::log2(8 * weight) / 2, 0.0, 2.0); }

/// The factor by which a photo outweighs the label of the background near its own camera
/// (shaders/blend.frag).
double own_factor(const VisibleSurface& s, std::uint32_t photo) {
    const double apart = (s.scene.poses[photo].center() - s.eye).norm();
    const double r = shader::own_angle * 2 * s.scene.spread / std::max(apart, 1e-30);
    return std::min(r * r, 1e6);
}

/// The tiles of one photo that the visible points show enough of, see shown_tiles.
TileNeeds needs_of_points(const VisibleSurface& s, const PlannedPhoto& p, double worth) {
    std::vector<float> weights(s.scene.clusters.size(), 0);
    for (std::size_t i = 0; i < p.clusters.size(); ++i) weights[p.clusters[i]] = p.weights[i];
    const bool own = own_factor(s, p.photo) > 0.1;  // shows all of the background, whatever its labels
    std::vector<SurfaceSample> samples;
    for (std::size_t i = 0; i < s.points.samples.size(); ++i) {
        const float weight = weights[s.points.clusters[i]];
        const std::uint32_t t = s.points.triangles[i];
        if (!(weight > 0) || !(sees(s.scene, p.photo, t) || (own && t >= s.scene.first_triangle_behind())))
            continue;
        samples.push_back(s.points.samples[i]);
        samples.back().coarser = spared_levels(weight);
    }
    return shown_tiles(s.scene.photos[p.photo], s.scene.lenses.of(p.photo), s.scene.poses[p.photo], samples,
                       s.points.pixels, worth);
}

/// Whether a photo sees the same side of a cluster as the viewer: if the cluster faces away from the viewer,
/// it must face away from the photo, too.
bool same_side(const package::ClusterRecord& c, bool away, const Eigen::Vector3d& photo) {
    return !away || faces_away(c, photo);
}

/// The weight of a photo in a cluster of the background: 1 for a label that it has. `own`: see own_factor.
double weight_behind(const PlanScene& scene, std::uint32_t photo, const package::ClusterRecord& c,
                     double own) {
    constexpr double least = 1.0 / 256;
    const double weight = own + has_label(scene, photo, c);
    return weight > least ? weight : -1;
}

/// Assigns each cluster to the chosen photos that see it. With `worth`, omits photos whose weight relative to
/// a photo that sees the whole cluster is below 1/1024, less than one color code: they would show only where
/// the other photo's weight maps are 0. A reduced plan has only photos that weigh much.
void assign_clusters(const VisibleSurface& s, const PlanSettings& settings,
                     std::vector<PlannedPhoto>& photos) {
    const double least = !(settings.worth > 0) ? 0 : settings.reduced ? 0.3 : 1.0 / 1024;
    const std::size_t words = package::visible_words(s.scene.triangles);
    std::vector<Eigen::Vector3d> centers;
    std::vector<double> own;
    for (const PlannedPhoto& p : photos) {
        centers.push_back(s.scene.poses[p.photo].center());
        own.push_back(own_factor(s, p.photo));
    }
    std::vector<double> weights(photos.size());
    for (const std::uint32_t index : s.clusters) {
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
            if (index >= s.scene.first_surrounding) {
                weights[i] = weight_behind(s.scene, p, c, own[i]);
                best = std::max(best, weights[i]);
                continue;
            }
            if (photos[i].paints) continue;
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
    VisibleSurface surface =
        visible_surface(scene, view, context.seen, settings.samples, settings.background);
    Plan plan;
    plan.choice =
        context.chosen ? *context.chosen : choose_photos(surface, settings, allowed, context.previous);
    plan.uncovered = plan.choice.uncovered;
    for (const ChosenPhoto& c : plan.choice.photos)
        plan.photos.push_back({c.photo, c.agreement, c.paints, {}, {}, {}, {}});
    assign_clusters(surface, settings, plan.photos);
    for (PlannedPhoto& p : plan.photos) {
        if (!settings.tiles) break;
        const bool by_points = settings.worth > 0 && !surface.triangles.empty();
        p.needs = by_points ? needs_of_points(surface, p, settings.worth)
                            : needs_of_clusters(surface, p, true, settings.samples);
        if (settings.complete && settings.worth == 0)
            p.later = needs_of_clusters(surface, p, false, settings.samples);
    }
    std::erase_if(plan.photos, [](const PlannedPhoto& p) { return p.clusters.empty(); });
    plan.clusters = std::move(surface.clusters);
    plan.transparent = std::move(surface.transparent);
    return plan;
}

std::vector<double> agreements(const PlanScene& scene, const View& view) {
    const VisibleSurface surface = visible_surface(scene, view, {}, 1, false);
    std::vector<double> out;
    for (std::uint32_t p = 0; p < scene.photos.size(); ++p) out.push_back(agreement(surface, p));
    return out;
}

}  // namespace vantage
