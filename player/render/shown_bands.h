#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "player/plan/plan_scene.h"
#include "player/render/render_settings.h"

namespace vantage {

/// The bands that make a picture, one or two.
struct ShownBands {
    std::uint32_t first = 0;
    std::optional<std::uint32_t> second{};
    BandView how = BandView::mix;
    double share = 0;  ///< of the second in a mix; of the width where it begins
};

/// What settings stand for in a scene of this many bands: numbers out of range are the first band or none,
/// and a mix with all or nothing of a band is one band.
ShownBands shown_bands(const BandSettings& settings, std::size_t bands);

/// The settings with which one band is drawn. Surroundings are those of the first band and are shown with it
/// only.
RenderSettings settings_of_band(RenderSettings settings, std::uint32_t band, const PlanScene& scene);

/// Those of `photos` that are of the band.
std::vector<std::uint32_t> photos_of_band(std::span<const std::uint32_t> photos, std::uint32_t band,
                                          const PlanScene& scene);

/// Dynamic weights per photo, relative to the others of the band; 1 for photos of other bands.
std::vector<double> weights_in_band(const View& view, const WeightSettings& settings, std::uint32_t band,
                                    const PlanScene& scene);

/// Keeps a band in the picture that another one takes the place of: until the photos of the new one are
/// there, and while they fade in.
class BandChange {
  public:
    /// The bands to draw at `now` seconds, if `wanted` are asked for. `ready`: whether the first band that
    /// was drawn last has photos to show.
    ShownBands update(ShownBands wanted, double now, bool ready);
    /// No change is in progress.
    bool settled() const { return !leaving_; }

  private:
    std::optional<std::uint32_t> shown_, leaving_;
    double begun_ = 0;                ///< seconds
    std::optional<double> ready_at_;  ///< seconds
};

}  // namespace vantage
