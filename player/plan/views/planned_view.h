#pragma once
#include <optional>
#include <vector>

#include "player/plan/plan.h"
#include "player/plan/views/seen_triangles.h"

namespace vantage {

/// Input of a plan for one view.
struct PlanOrder {
    View view{};
    /// `settings.samples` is for one sample per pixel; `side` multiplies it.
    PlanSettings settings{};
    int side = 0;
    std::vector<std::uint32_t> photos{};  ///< candidates
    SeenTriangles seen{};                 ///< used if the view has changed little since they were seen
    /// Photos that frames may draw until those of the plan are loaded. These photos are planned as a separate
    /// set, because in a joint plan, clusters may lack photos that other photos outweigh.
    std::vector<std::uint32_t> drawn{};
    bool steady = false;  ///< `drawn` has exactly the photos of the previous plan
};

/// A plan and the state that the next one depends on.
struct PlannedView {
    PlanOrder made_for;
    Plan plan;
    std::vector<PlannedPhoto> kept;  ///< the plan for all drawn photos; empty if `plan` has the same photos
    bool uses_seen = false;  ///< the plan was made for the visible triangles instead of everything in view
    /// The triangles visible from exactly this view; null: not yet known. The triangles are kept while the
    /// view is unchanged: each sample of a pixel shows slightly different triangles, so plans for each
    /// sample's triangles would never converge.
    std::shared_ptr<const std::vector<std::uint32_t>> at_rest{};
    std::optional<View> chosen_for{};  ///< the view that the photos were chosen for
    int plans_of_choice = 0;           ///< number of plans with these photos
};

/// The settings for all samples of a pixel.
PlanSettings settings_for_samples(const PlanOrder& order);

/// Whether the plan has the photos and settings of the order.
bool suits(const PlannedView& plan, const PlanOrder& order);

/// Whether the plan is the requested one. `shared`: photos chosen for another view and used for this one.
bool is_current(const PlannedView& plan, const PlanOrder& order, const PhotoChoice* shared = nullptr);

/// Whether frames can be drawn with the plan until the requested one is made. This is the case if the plan
/// has the requested photos and settings, was made for visible triangles and a similar view, and has all
/// clusters of the mesh in view.
bool can_stand_for(const PlanScene& scene, const PlannedView& plan, const PlanOrder& order,
                   std::span<const std::uint32_t> clusters_in_view);

/// Makes the requested plan. `before`: the previous plan; null for the first one. This is a pure function.
PlannedView plan_view(const PlanScene& scene, PlanOrder order, const PlannedView* before,
                      const PhotoChoice* shared = nullptr);

/// The view extended to all samples of its pixels, which lie up to half a pixel from a pixel's center.
inline View with_samples(const View& view) { return widened(view, 1); }

}  // namespace vantage
