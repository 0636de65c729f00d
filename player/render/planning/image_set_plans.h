#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "player/plan/views/view_plan.h"
#include "player/render/planning/shown_image_sets.h"

namespace vantage {

/// An image set of a frame and the data from which it is drawn.
struct ImageSetFrame {
    RenderSettings settings{};
    std::vector<std::uint32_t> photos{};
    ViewPlan* plan = nullptr;
    bool second = false;  ///< this is the second of two image sets
};

/// The plans of the one or two shown image sets; each image set keeps its plan as long as it is shown.
class ImageSetPlans {
  public:
    /// `scene` must outlive it.
    explicit ImageSetPlans(const PlanScene& scene) : scene_(&scene), first_(scene) {}

    /// Chooses the image sets of the frame at `now` seconds.
    void choose(const RenderSettings& settings, double now);
    /// Call this instead of choose() to show the image sets that another eye's plans chose.
    void follow(const ImageSetPlans& other) { show(other.shown_); }
    /// The chosen image sets, each drawn from its own photos among `photos`; replaces the content of
    /// `frames`. Valid until the next choice.
    void find_frames(const RenderSettings& settings, std::span<const std::uint32_t> photos,
                     std::vector<ImageSetFrame>& frames);

    const ShownImageSets& shown() const { return shown_; }
    const ViewPlan& first() const { return first_; }
    /// Whether one of the plans has this photo.
    bool uses(std::uint32_t photo) const;
    /// Whether no photo or image set is fading.
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
