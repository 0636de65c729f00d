#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "player/plan/plan_scene.h"
#include "player/plan/plan_settings.h"
#include "player/plan/tile_needs.h"
#include "player/view.h"

namespace vantage {

struct PlannedPhoto {
    std::uint32_t photo;
    double agreement;                     ///< with the view: share of it seen, by angle, in [0, 1]
    std::vector<std::uint32_t> clusters;  ///< drawn with this photo, ascending
    std::vector<float> weights;           ///< of each, beside the best photo's, at most 1
    TileNeeds needs;                      ///< of clusters seen, see make_plan
    TileNeeds later;                      ///< of clusters in view that were not seen
};

/// What a view is drawn from; photos by falling agreement.
struct Plan {
    std::vector<std::uint32_t> clusters;
    std::vector<PlannedPhoto> photos;
    double uncovered = 0;  ///< share of what some allowed photo sees in view that none of the chosen does
};

/// Chooses among the photos `allowed`; those in `previous` are preferred a little, so that the choice does
/// not flicker. `seen` are triangles that samples of the view (or one just before) showed, numbers from 1:
/// with them the plan covers what is seen, without them all that is in view. Depends on its arguments alone.
Plan make_plan(const PlanScene& scene, const View& view, const PlanSettings& settings,
               std::span<const std::uint32_t> allowed, std::span<const std::uint32_t> previous = {},
               std::span<const std::uint32_t> seen = {});

/// Agreement of every photo with a view, 0 for one that sees nothing of it.
std::vector<double> agreements(const PlanScene& scene, const View& view);

}  // namespace vantage
