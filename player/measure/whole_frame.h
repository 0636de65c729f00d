#pragma once
#include <array>
#include <vector>

#include "player/measure/evaluation/luminance.h"
#include "player/measure/evaluation/picture_metrics.h"
#include "player/render/renderer.h"

namespace vantage {

/// A rendered view as displayed in the window: opaque, with plain shading on surfaces without photos, and the
/// background elsewhere. `rendered`: the same view with transparent holes, with `side` * `side` samples per
/// pixel. A pixel in which only some samples have a color is completed with the mean color that its samples
/// have without photos.
Picture as_in_window(Renderer& renderer, const View& view, RenderSettings settings, const Picture& rendered,
                     int side);

/// Squared difference between the window's frame and the photo at each pixel, summed over three channels; 0
/// where the photo has no valid pixel (`taken`). `gain` is applied to the pixels flagged in `colored`.
Plane squared_errors(const Picture& photo, const Picture& shown, const std::vector<bool>& taken,
                     const std::vector<bool>& colored, const std::array<double, 3>& gain);

/// The difference between the window's whole frame and the photo, including holes.
struct FrameScore {
    std::size_t pixels = 0;          ///< pixels that are valid in the photo; if 0, all other values are 0
    double psnr = 0, psnr_gain = 0;  ///< dB, as in PictureScore
    double ssim = 0, ssim_gain = 0;
};

/// `shown`: see as_in_window; `taken`: valid pixels of the photo; `colored`: colored pixels of the rendered
/// picture. `gain` is that of the colored pixels (PictureScore::gain) and only applies to them, since shading
/// and background have no exposure. `errors`: squared_errors of the same frame.
FrameScore score_frame(const Picture& photo, const Picture& shown, const std::vector<bool>& taken,
                       const std::vector<bool>& colored, const std::array<double, 3>& gain,
                       const Plane& errors);

}  // namespace vantage
