#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "player/plan/views/view_plan.h"
#include "player/render/planning/shown_image_sets.h"

namespace vantage {

/// An image set of a frame and what it is drawn from.
struct ImageSetFrame {
    RenderSettings settings{};
    std::vector<std::uint32_t> photos{};
    ViewPlan* plan = nullptr;
    bool second = false;  ///< of two image sets
};

/// The plans of the image sets that are shown, one or two; each image set keeps its own as long as it is
/// shown.
class ImageSetPlans {
  public:
    /// `scene` must outlive it.
    explicit ImageSetPlans(const PlanScene& scene) : scene_(&scene), first_(scene) {}

    /// Chooses the image sets of the frame at `now` seconds.
    void choose(const RenderSettings& settings, double now);
    /// Instead of choose(): shows the image sets that another eye's plans have chosen.
    void follow(const ImageSetPlans& other) { show(other.shown_); }
    /// The chosen image sets, drawn from those of `photos` that are theirs, in place of what is in `frames`.
    /// Valid until the next choice.
    void find_frames(const RenderSettings& settings, std::span<const std::uint32_t> photos,
                     std::vector<ImageSetFrame>& frames);

    const ShownImageSets& shown() const { return shown_; }
    const ViewPlan& first() const { return first_; }
    /// Whether one of the plans has this photo.
    bool uses(std::uint32_t photo) const;
    /// No photos and no image sets are fading.
    bool settled() const;

  private:
    void show(const ShownImageSets& wanted);

    const PlanScene* scene_;
    ViewPlan first_;
    std::optional<ViewPlan> second_;
    ImageSetChange change_;
    ShownImageSets shown_;
};

}  // namespace vantage
