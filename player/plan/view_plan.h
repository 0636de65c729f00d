#pragma once
#include <optional>
#include <span>
#include <vector>

#include "player/plan/plan.h"
#include "player/view/view.h"

namespace vantage {

/// The triangles that a view showed; empty until the first readback. Equal versions mean equal triangles.
struct SeenTriangles {
    std::span<const std::uint32_t> triangles;  ///< as in Seen
    const View& view;
    std::uint64_t version;
    bool at_pixels = true;  ///< else they are of several views
};

/// The plan for the current view, remade when anything it depends on changes, and the transition from the
/// photos drawn before to those it chooses. During a transition both sets are to be drawn, each blended by
/// itself at full weight, and the two pictures mixed: if instead a photo's weight faded, one that far
/// outweighs the others would appear in the first frame and disappear in the last one.
class ViewPlan {
  public:
    explicit ViewPlan(const PlanScene& scene)
        : scene_(&scene), drawn_(scene.photos.size(), false), before_(drawn_) {}

    /// Remakes the plan if necessary. `settings.samples` applies to one sample per pixel; `side` multiplies
    /// it. `seen` is used if the view has changed little since. Once it is of this very view, it is kept:
    /// each sample of a pixel shows slightly different triangles, and plans for each would never come to
    /// rest. `shared`: the photos are these, as they were chosen for another view.
    void update(const View& view, const PlanSettings& settings, std::span<const std::uint32_t> photos,
                int side, const SeenTriangles& seen, const PhotoChoice* shared = nullptr);
    /// Advances the transition to `now` seconds. When it has ended, the next one begins if the planned photos
    /// that are `ready` (one flag per photo) are not those drawn. At once if nothing was drawn before.
    void fade(const PlanSettings& settings, double now, const std::vector<bool>& ready);

    const Plan& plan() const { return plan_; }
    /// The photos to draw: planned ones by decreasing agreement, then those no longer planned.
    std::vector<const PlannedPhoto*> drawn() const;
    /// The photos that those of drawn() replace; the same ones if no transition is in progress.
    std::vector<const PlannedPhoto*> before() const;
    /// The share of drawn() in the picture, in [0, 1]; 1: no transition is in progress.
    double progress() const { return progress_; }
    /// The plan of all photos drawn; empty if they are those of plan().
    const std::vector<PlannedPhoto>& kept() const { return kept_; }
    /// The plan was made for the triangles seen, not for all that are in view.
    bool uses_seen() const { return uses_seen_; }
    /// No transition is in progress.
    bool settled() const { return progress_ >= 1; }
    /// A plan for a view to come, preferring the photos of the current one.
    Plan ahead(const View& next, const PlanSettings& settings, int side) const;

  private:
    struct Key {
        View view;
        PlanSettings settings;
        int side;
        std::vector<std::uint32_t> photos;
        std::uint64_t seen;  ///< version
    };
    bool keeps_choice(const View& view, bool moves);
    void plan_drawn(const View& view, const PlanSettings& settings, std::span<const std::uint32_t> photos);

    const PlanScene* scene_;
    std::optional<Key> made_for_;
    std::vector<std::uint32_t> at_rest_;  ///< the triangles seen from made_for_'s very view; empty: not yet
    bool uses_seen_ = false;
    std::optional<View> chosen_for_;  ///< the view that plan_'s photos were chosen for
    int plans_of_choice_ = 0;         ///< that had these photos
    Plan plan_;
    std::vector<PlannedPhoto> kept_;    ///< see kept()
    std::vector<bool> drawn_, before_;  ///< per photo; the same if no transition is in progress
    double progress_ = 1, last_ = 0;    ///< `last_` in seconds
};

}  // namespace vantage
