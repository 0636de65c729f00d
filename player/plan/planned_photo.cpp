#include "player/plan/planned_photo.h"

#include "player/plan/selection/shown_tiles.h"

namespace vantage {
namespace {

/// The tiles of one photo for its clusters, while the visible triangles are unknown.
TileNeeds needs_of_clusters(const VisibleSurface& s, const PlannedPhoto& p, double samples) {
    std::vector<ClusterLevels> levels;
    const Intrinsics& k = s.scene.intrinsics[p.photo];
    for (const std::uint32_t c : p.clusters)
        levels.push_back(
            {c, sampled_levels(s.scene.clusters[c], k, s.scene.poses[p.photo], s.view, samples)});
    return tile_needs(s.scene.photos[p.photo], s.scene.lenses.of(p.photo), s.scene.coverage[p.photo], levels);
}

}  // namespace

std::vector<std::uint32_t> numbers_of(std::span<const PlannedPhoto> photos) {
    std::vector<std::uint32_t> out;
    for (const PlannedPhoto& p : photos) out.push_back(p.photo);
    return out;
}

void add_needs(PlannedPhoto& p, const VisibleSurface& s, const PlanSettings& settings,
               const std::function<float(std::size_t)>& weight, double coarse) {
    if (s.triangles.empty()) {
        p.needs = needs_of_clusters(s, p, settings.samples);
        return;
    }
    std::vector<float> weights(s.points.samples.size());
    for (std::size_t i = 0; i < weights.size(); ++i) weights[i] = weight(i);
    p.needs = shown_tiles(s.scene.photos[p.photo], s.scene.lenses.of(p.photo), s.scene.poses[p.photo],
                          {s.points.samples, weights, s.points.pixels}, settings.worth, coarse);
}

}  // namespace vantage
