#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "player/plan/plan_scene.h"
#include "player/render/render_settings.h"

namespace vantage {

/// The image sets that make a picture, one or two.
struct ShownImageSets {
    std::uint32_t first = 0;
    std::optional<std::uint32_t> second{};
    ImageSetView how = ImageSetView::mix;
    double share = 0;  ///< of the second in a mix; of the width where it begins
};

/// What settings stand for in a scene of this many image sets: numbers out of range are the first image set
/// or none, and a mix with all or nothing of an image set is one image set.
ShownImageSets shown_image_sets(const ImageSetSettings& settings, std::size_t image_sets);

/// Makes the settings those with which one image set is drawn. The background is that of the first image set
/// and is shown with it only.
void choose_image_set(RenderSettings& settings, std::uint32_t image_set, const PlanScene& scene);

/// Dynamic weights per photo, relative to the others of the image set; 1 for photos of other image sets.
std::vector<double> weights_in_image_set(const View& view, const WeightSettings& settings,
                                         std::uint32_t image_set, const PlanScene& scene);

/// Keeps an image set in the picture that another one takes the place of: until the photos of the new one are
/// there, and while they fade in.
class ImageSetChange {
  public:
    /// The image sets to draw at `now` seconds, if `wanted` are asked for. `ready`: whether the first image
    /// set that was drawn last has photos to show.
    ShownImageSets update(ShownImageSets wanted, double now, bool ready);
    /// No change is in progress.
    bool settled() const { return !leaving_; }

  private:
    std::optional<std::uint32_t> shown_, leaving_;
    double begun_ = 0;                ///< seconds
    std::optional<double> ready_at_;  ///< seconds
};

}  // namespace vantage
