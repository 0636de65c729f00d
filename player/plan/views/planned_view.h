#pragma once
#include <optional>
#include <vector>

#include "player/plan/plan.h"
#include "player/plan/views/seen_triangles.h"

namespace vantage {

/// What a view is planned for.
struct PlanOrder {
    View view{};
    /// `samples` applies to one sample per pixel; `side` multiplies it.
    PlanSettings settings{};
    int side = 0;
    std::vector<std::uint32_t> photos{};  ///< to choose from
    SeenTriangles seen{};                 ///< used if the view has changed little since
    /// Photos that frames may draw until those of the plan are there. They are planned as a set of their own:
    /// in the plan of others, clusters may lack photos that those outweigh.
    std::vector<std::uint32_t> drawn{};
    bool steady = false;  ///< those are the photos of the plan before, and no others
};

/// A plan and what the next one depends on.
struct PlannedView {
    PlanOrder made_for;
    Plan plan;
    std::vector<PlannedPhoto> kept;  ///< the plan of all photos drawn; empty if they are those of `plan`
    bool uses_seen = false;  ///< the plan was made for the triangles seen, not for all that are in view
    /// The triangles seen from this very view; null: not yet. They are kept: each sample of a pixel shows
    /// slightly different triangles, and plans for each would never come to rest.
    std::shared_ptr<const std::vector<std::uint32_t>> at_rest{};
    std::optional<View> chosen_for{};  ///< the view that the photos were chosen for
    int plans_of_choice = 0;           ///< that had these photos
};

/// The settings for all samples of a pixel.
PlanSettings settings_for_samples(const PlanOrder& order);

/// Whether the plan is of the same photos, with the same settings.
bool suits(const PlannedView& plan, const PlanOrder& order);

/// Whether the plan is the one that is ordered. `shared`: the photos are these, as they were chosen for
/// another view.
bool is_current(const PlannedView& plan, const PlanOrder& order, const PhotoChoice* shared = nullptr);

/// Whether frames can be drawn with the plan until the one that is ordered is made: it suits, it was made for
/// triangles that are seen, from a similar view, and it has all clusters of the mesh that are in view.
bool can_stand_for(const PlanScene& scene, const PlannedView& plan, const PlanOrder& order,
                   std::span<const std::uint32_t> clusters_in_view);

/// Makes the plan that is ordered, after `before`; null: the first one. A pure function.
PlannedView plan_view(const PlanScene& scene, PlanOrder order, const PlannedView* before,
                      const PhotoChoice* shared = nullptr);

/// The view with all samples of its pixels, which lie up to half a pixel from a pixel's center.
inline View with_samples(const View& view) { return widened(view, 1); }

}  // namespace vantage
