#pragma once
#include <optional>
#include <span>
#include <vector>

#include "player/camera/view.h"
#include "player/plan/plan.h"

namespace vantage {

/// The triangles that a view showed, numbered from 1 (0: none), one per sampled pixel; empty until the first
/// readback. Equal versions mean equal triangles.
struct SeenTriangles {
    std::span<const std::uint32_t> triangles;
    const View& view;
    std::uint64_t version;
};

/// The plan for the current view, remade when anything it depends on changes, and the fading in and out of
/// its photos.
class ViewPlan {
  public:
    explicit ViewPlan(const PlanScene& scene) : scene_(&scene), presence_(scene.photos.size(), 0) {}

    /// Remakes the plan if necessary. `settings.samples` applies to one sample per pixel; `side` multiplies
    /// it. `seen` is used if the view has changed little since.
    void update(const View& view, const PlanSettings& settings, std::span<const std::uint32_t> photos,
                int side, const SeenTriangles& seen);
    /// Advances fading to `now` seconds; planned photos fade in when they are `ready` (one flag per photo).
    void fade(const PlanSettings& settings, double now, const std::vector<bool>& ready);

    const Plan& plan() const { return plan_; }
    /// No longer planned, fading out.
    const std::vector<PlannedPhoto>& leaving() const { return leaving_; }
    /// The photos to draw: planned ones by decreasing agreement, then leaving ones.
    std::vector<const PlannedPhoto*> present(const PlanSettings& settings) const;
    /// How far a photo has faded in, 0 to 1.
    float presence(std::uint32_t photo) const { return presence_[photo]; }
    /// The plan was made for the triangles seen, not for all that are in view.
    bool uses_seen() const { return uses_seen_; }
    /// No photo is fading.
    bool settled() const;
    /// A plan for a view to come, preferring the photos of the current one.
    Plan ahead(const View& next, const PlanSettings& settings, int side) const;

  private:
    struct Key {
        View view;
        PlanSettings settings;
        std::vector<std::uint32_t> photos;
        std::uint64_t seen;  ///< version
    };
    void plan_leaving(const View& view, const PlanSettings& settings, std::span<const std::uint32_t> photos,
                      std::vector<std::uint32_t> previous);

    const PlanScene* scene_;
    std::optional<Key> made_for_;
    bool uses_seen_ = false;
    Plan plan_;
    std::vector<PlannedPhoto> leaving_;
    std::vector<float> presence_;  ///< per photo, 0 to 1
    double last_ = 0;              ///< seconds
};

}  // namespace vantage
