#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "player/plan/plan_settings.h"
#include "player/plan/selection/tile_needs.h"
#include "player/plan/visible_surface.h"

namespace vantage {

struct PlannedPhoto {
    std::uint32_t photo;
    double agreement;                     ///< agreement with the view, see agreement(), in [0, 1]
    std::vector<std::uint32_t> clusters;  ///< clusters drawn with this photo, ascending
    std::vector<float> weights;           ///< one per cluster, relative to the best photo's weight, at most 1
    TileNeeds needs;                      ///< tiles for the visible parts of the clusters
};

std::vector<std::uint32_t> numbers_of(std::span<const PlannedPhoto> photos);

/// Lists the tiles of a photo that its clusters need. `weight`: the photo's weight at a point on the surface,
/// in [0, 1]; 0 if the photo does not show it. The photo's weight maps are also read at the level `coarse` if
/// that level is coarser.
void add_needs(PlannedPhoto& photo, const VisibleSurface& surface, const PlanSettings& settings,
               const std::function<float(std::size_t point)>& weight, double coarse = 0);

}  // namespace vantage
