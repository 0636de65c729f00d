#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "player/plan/plan_scene.h"
#include "player/plan/plan_settings.h"
#include "player/plan/planned_photo.h"
#include "player/plan/selection/chosen_photos.h"
#include "player/view/view.h"

namespace vantage {

/// The clusters and photos that a view is drawn from; photos by decreasing agreement.
struct Plan {
    std::vector<std::uint32_t> clusters;  ///< opaque
    std::vector<PlannedPhoto> photos;     ///< photos of the mesh
    std::vector<PlannedPhoto> behind;     ///< photos of the background, see plan_background
    PhotoChoice choice;  ///< the full selection, including photos that show none of the clusters
    /// Of the surface in view that any allowed photo sees, the fraction that no chosen photo sees.
    double uncovered = 0;
};

/// Information about a view from previous frames.
struct PlanContext {
    std::span<const std::uint32_t> previous{};  ///< photos that are slightly preferred, to avoid flicker
    /// With the visible triangles, the plan covers the visible surface; without them, it covers everything in
    /// view.
    Seen seen{};
    const PhotoChoice* chosen = nullptr;  ///< fixed choice of photos, as made for another view
};

/// Chooses among the `allowed` photos. This is a pure function.
Plan make_plan(const PlanScene& scene, const View& view, const PlanSettings& settings,
               std::span<const std::uint32_t> allowed, const PlanContext& context = {});

/// Agreement of each photo with a view, see agreement().
std::vector<double> agreements(const PlanScene& scene, const View& view);

}  // namespace vantage
