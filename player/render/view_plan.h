#pragma once
#include <optional>
#include <span>
#include <vector>

#include "player/plan/plan.h"
#include "player/render/render_settings.h"
#include "player/render/seen_triangles.h"

namespace vantage {

/// The plan for the view that is drawn now, made anew where something it depends on has changed, and how far
/// its photos have faded in and former ones out.
class ViewPlan {
  public:
    explicit ViewPlan(const PlanScene& scene) : scene_(&scene), presence_(scene.photos.size(), 0) {}

    /// `side`: samples along a pixel's side. What was seen last counts where it still tells what the view
    /// shows.
    void update(const View& view, const RenderSettings& settings, std::span<const std::uint32_t> photos,
                int side, const SeenTriangles& seen);
    /// Lets photos fade, at `now` seconds; those of the plan come in once they are `ready` (a photo).
    void fade(const RenderSettings& settings, double now, const std::vector<bool>& ready);

    const Plan& plan() const { return plan_; }
    /// Not planned any more, fading out.
    const std::vector<PlannedPhoto>& leaving() const { return leaving_; }
    /// The photos that are drawn: planned ones by falling agreement, then leaving ones.
    std::vector<const PlannedPhoto*> present(const RenderSettings& settings) const;
    float presence(std::uint32_t photo) const { return presence_[photo]; }
    /// The plan was made with what the view shows.
    bool knows_seen() const { return knows_seen_; }
    /// Nothing is fading.
    bool settled() const;
    /// A plan for another view, with the photos of this one where they serve.
    Plan ahead(const View& next, const RenderSettings& settings, int side) const;

  private:
    struct Key {
        View view;
        PlanSettings settings;
        std::vector<std::uint32_t> photos;
        std::uint64_t seen;  ///< version
    };
    void plan_leaving(const View& view, const RenderSettings& settings, std::span<const std::uint32_t> photos,
                      std::vector<std::uint32_t> former);

    const PlanScene* scene_;
    std::optional<Key> made_for_;
    bool knows_seen_ = false;
    Plan plan_;
    std::vector<PlannedPhoto> leaving_;
    std::vector<float> presence_;  ///< a photo, 0 to 1
    double last_ = 0;
};

}  // namespace vantage
