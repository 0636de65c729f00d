#include "player/survey/footprint.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "player/plan/visible_surface.h"
#include "player/survey/ray_cast.h"

namespace vantage {
namespace {

/// Share of the way from the camera to the point on which the mesh may not be in between: positions are
/// single precision.
constexpr double free_share = 1 - 1e-4;

bool is_hidden(const PlanScene& scene, std::uint32_t photo, const Eigen::Vector3d& position) {
    const Eigen::Vector3d eye = scene.poses[photo].center();
    return first_hit(scene, {eye, position - eye}, {0, free_share}).has_value();
}

}  // namespace

std::optional<Footprint> smallest_footprint(const PlanScene& scene, std::uint32_t triangle,
                                            const Eigen::Vector3d& position) {
    std::vector<Footprint> candidates;
    for (std::uint32_t p = 0; p < scene.photos.size(); ++p) {
        if (triangle >= scene.triangles || scene.visible[p].empty() || !sees(scene, p, triangle)) continue;
        const Intrinsics& k = scene.intrinsics[p];
        const auto at = project(k, scene.poses[p], position);
        if (at && in_frame(k, at->pixel)) candidates.push_back({at->z / std::sqrt(k.fx * k.fy), p});
    }
    std::ranges::stable_sort(candidates, {}, &Footprint::size);
    for (const Footprint& f : candidates)
        if (std::isfinite(f.size) && !is_hidden(scene, f.photo, position)) return f;
    return {};
}

}  // namespace vantage
