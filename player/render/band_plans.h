#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "player/plan/view_plan.h"
#include "player/render/shown_bands.h"

namespace vantage {

/// A band of a frame and what it is drawn from.
struct BandFrame {
    RenderSettings settings;
    std::vector<std::uint32_t> photos;
    ViewPlan* plan;
    bool second;  ///< of two bands
};

/// The plans of the bands that are shown, one or two; each band keeps its own as long as it is shown.
class BandPlans {
  public:
    /// `scene` must outlive it.
    explicit BandPlans(const PlanScene& scene) : scene_(&scene), first_(scene) {}

    /// Chooses the bands of the frame at `now` seconds.
    void choose(const RenderSettings& settings, double now);
    /// Instead of choose(): shows the bands that another eye's plans have chosen.
    void follow(const BandPlans& other) { show(other.shown_); }
    /// The chosen bands, drawn from those of `photos` that are theirs. Valid until the next choice.
    std::vector<BandFrame> frames(const RenderSettings& settings, std::span<const std::uint32_t> photos);

    const ShownBands& shown() const { return shown_; }
    const Plan& plan_of_first() const { return first_.plan(); }
    /// Whether one of the plans has this photo.
    bool uses(std::uint32_t photo) const;
    /// No photos and no bands are fading.
    bool settled() const;

  private:
    void show(const ShownBands& wanted);
    std::vector<const ViewPlan*> plans() const;

    const PlanScene* scene_;
    ViewPlan first_;
    std::optional<ViewPlan> second_;
    BandChange change_;
    ShownBands shown_;
};

}  // namespace vantage
