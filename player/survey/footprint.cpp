#include "player/survey/footprint.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "player/plan/visible_surface.h"
#include "player/survey/ray_cast.h"

namespace vantage {
namespace {

/// The fraction of the segment from the camera to the point that must be unobstructed. It is below 1 because
/// positions have single precision.
constexpr double free_share = 1 - 1e-4;

bool is_hidden(const PlanScene& scene, std::uint32_t photo, const Eigen::Vector3d& position) {
    const Eigen::Vector3d eye = scene.poses[photo].center();
    return first_hit(scene, {eye, position - eye}, {0, free_share}).has_value();
}

/// Footprints of the photos whose coverage includes the triangle and whose frame contains the position,
/// smallest first.
std::vector<Footprint> likely_footprints(const PlanScene& scene, std::uint32_t triangle,
                                         const Eigen::Vector3d& position) {
    std::vector<Footprint> out;
    for (std::uint32_t p = 0; p < scene.photos.size(); ++p) {
        if (triangle >= scene.triangles || scene.visible[p].empty() || !sees(scene, p, triangle)) continue;
        const Intrinsics& k = scene.intrinsics[p];
        const auto at = project(k, scene.poses[p], position);
        if (at && in_frame(k, at->pixel)) out.push_back({at->z / std::sqrt(k.fx * k.fy), p});
    }
    std::erase_if(out, [](const Footprint& f) { return !std::isfinite(f.size); });
    std::ranges::stable_sort(out, {}, &Footprint::size);
    return out;
}

}  // namespace

std::vector<Footprint> footprints(const PlanScene& scene, std::uint32_t triangle,
                                  const Eigen::Vector3d& position) {
    std::vector<Footprint> out = likely_footprints(scene, triangle, position);
    std::erase_if(out, [&](const Footprint& f) { return is_hidden(scene, f.photo, position); });
    return out;
}

std::optional<Footprint> smallest_footprint(const PlanScene& scene, std::uint32_t triangle,
                                            const Eigen::Vector3d& position) {
    for (const Footprint& f : likely_footprints(scene, triangle, position))
        if (!is_hidden(scene, f.photo, position)) return f;
    return {};
}

}  // namespace vantage
