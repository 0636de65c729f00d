#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "player/plan/plan_scene.h"
#include "player/render/render_settings.h"

namespace vantage {

/// The one or two image sets of a picture.
struct ShownImageSets {
    std::uint32_t first = 0;
    std::optional<std::uint32_t> second{};
    ImageSetView how = ImageSetView::mix;
    double share = 0;  ///< weight of the second set in a mix, or the fraction of the width at which it begins
};

/// Resolves settings for a scene with this many image sets: numbers out of range become the first image set
/// or none, and a mix with a share of 0 or 1 becomes a single image set.
ShownImageSets shown_image_sets(const ImageSetSettings& settings, std::size_t image_sets);

/// Changes the settings to those for drawing one image set. The background belongs to the first image set and
/// is shown only with it.
void choose_image_set(RenderSettings& settings, std::uint32_t image_set, const PlanScene& scene);

/// Dynamic weights per photo, relative to the other photos of the image set; 1 for photos of other image
/// sets.
std::vector<double> weights_in_image_set(const View& view, const WeightSettings& settings,
                                         std::uint32_t image_set, const PlanScene& scene);

/// Keeps the previous image set in the picture until the photos of the new one have been loaded and have
/// faded in.
class ImageSetChange {
  public:
    /// The image sets to draw at `now` seconds if `wanted` are selected. `ready`: whether the first of the
    /// image sets that were last drawn has photos to show.
    ShownImageSets update(ShownImageSets wanted, double now, bool ready);
    /// Whether no change is in progress.
    bool settled() const { return !leaving_; }

  private:
    std::optional<std::uint32_t> shown_, leaving_;
    double begun_ = 0;                ///< seconds
    std::optional<double> ready_at_;  ///< seconds
};

}  // namespace vantage
