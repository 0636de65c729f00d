#include "player/plan/views/planned_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace vantage {
namespace {

/// The eye, or the center of an orthographic picture, whose eye is far away.
Eigen::Vector3d place_of(const View& view) {
    return view.cam_from_origin.center() + view.orthographic_depth * view.cam_from_origin.direction();
}

/// Whether the surface visible from `before` is a good prediction for `now`: rotation of at most 20 degrees,
/// translation of at most a tenth of the model's diagonal.
bool shows_much_of(const View& before, const View& now, const PlanScene& scene) {
    const double turned = before.cam_from_origin.direction().dot(now.cam_from_origin.direction());
    const double moved = (place_of(before) - place_of(now)).norm();
    return turned > std::cos(std::numbers::pi / 9) && moved < 0.1 * scene.size;
}

/// In motion, photos are selected again only in every third plan, because selection takes as long as
/// everything else.
bool keeps_choice(const PlanScene& scene, const PlannedView& before, const PlannedView& plan) {
    constexpr int max_plans = 3;
    const PlanOrder &now = plan.made_for, &then = before.made_for;
    const bool moves = then.settings == now.settings && then.photos == now.photos &&
                       !same_view(then.view, now.view) && !now.settings.complete;
    return moves && plan.uses_seen && before.chosen_for &&
           shows_much_of(*before.chosen_for, now.view, scene) && before.plans_of_choice < max_plans;
}

/// A separate plan for the drawn photos, unless the plan has the same photos.
std::vector<PlannedPhoto> plan_drawn(const PlanScene& scene, const PlanOrder& order, const Plan& plan) {
    std::vector<std::uint32_t> planned = numbers_of(plan.photos);
    std::ranges::sort(planned);
    if (order.drawn.empty() || order.settings.complete || (order.steady && order.drawn == planned)) return {};
    PlanSettings all = order.settings;
    all.photos = 0;
    all.background = false;  // independent of the mesh's photos
    all.tiles = false;       // not requested for photos that are being replaced
    // Some photos may not be loaded yet, so no photo may exclude others from a cluster.
    if (!all.reduced) all.sharpness = 0;
    return make_plan(scene, with_samples(order.view), all, order.drawn).photos;
}

/// A planned view in its state before photos are chosen.
PlannedView begun_plan(const PlanScene& scene, PlanOrder order, const PlannedView* before) {
    PlannedView out;
    const bool same_settings = before && before->made_for.settings == order.settings;
    if (same_settings && before->at_rest && same_view(before->made_for.view, order.view)) {
        out.uses_seen = before->uses_seen;
        out.at_rest = before->at_rest;
    } else {
        const SeenTriangles& seen = order.seen;
        out.uses_seen = !seen.triangles().empty() && shows_much_of(seen.view, order.view, scene);
        // After a change of settings, the triangles may be outdated.
        if (out.uses_seen && same_settings && same_view(seen.view, order.view)) out.at_rest = seen.numbers;
    }
    out.made_for = std::move(order);
    return out;
}

}  // namespace

PlanSettings settings_for_samples(const PlanOrder& order) {
    PlanSettings settings = order.settings;
    settings.samples *= order.side;
    return settings;
}

bool suits(const PlannedView& plan, const PlanOrder& order) {
    const PlanOrder& made_for = plan.made_for;
    return made_for.settings == order.settings && made_for.side == order.side &&
           made_for.photos == order.photos;
}

bool is_current(const PlannedView& plan, const PlanOrder& order, const PhotoChoice* shared) {
    const PlanOrder& made_for = plan.made_for;
    const bool chosen_here = shared ? shared->photos == plan.plan.choice.photos
                                    : plan.chosen_for && same_view(*plan.chosen_for, order.view);
    return suits(plan, order) && same_view(made_for.view, order.view) && chosen_here &&
           (plan.at_rest || made_for.seen.version == order.seen.version);
}

bool can_stand_for(const PlanScene& scene, const PlannedView& plan, const PlanOrder& order,
                   std::span<const std::uint32_t> clusters_in_view) {
    // Only clusters of the mesh matter, because all photos show the background.
    const std::span mesh(clusters_in_view.begin(),
                         std::ranges::lower_bound(clusters_in_view, scene.first_surrounding));
    return suits(plan, order) && plan.uses_seen && shows_much_of(plan.made_for.view, order.view, scene) &&
           std::ranges::includes(plan.plan.clusters, mesh);
}

PlannedView plan_view(const PlanScene& scene, PlanOrder order, const PlannedView* before,
                      const PhotoChoice* shared) {
    PlannedView out = begun_plan(scene, std::move(order), before);
    const PlanOrder& made_for = out.made_for;
    const bool keeps = !shared && before && keeps_choice(scene, *before, out);
    if (keeps) {
        shared = &before->plan.choice;
        out.chosen_for = before->chosen_for;
        out.plans_of_choice = before->plans_of_choice + 1;
    } else {
        out.chosen_for = made_for.view;
        out.plans_of_choice = 1;
    }
    std::span<const std::uint32_t> known;
    if (out.at_rest)
        known = *out.at_rest;
    else if (out.uses_seen)
        known = made_for.seen.triangles();
    const Seen seen{known, known.empty() || !made_for.seen.at_pixels ? nullptr
                           : out.at_rest                             ? &made_for.view
                                                                     : &made_for.seen.view};
    const std::vector<std::uint32_t> previous =
        before ? numbers_of(before->plan.photos) : std::vector<std::uint32_t>();
    out.plan = make_plan(scene, with_samples(made_for.view), settings_for_samples(made_for), made_for.photos,
                         {previous, seen, shared});
    out.kept = plan_drawn(scene, made_for, out.plan);
    return out;
}

}  // namespace vantage
