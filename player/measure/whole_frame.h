#pragma once
#include <array>
#include <vector>

#include "player/measure/evaluation/luminance.h"
#include "player/measure/evaluation/picture_metrics.h"
#include "player/render/renderer.h"

namespace vantage {

/// A rendered view as the window shows it: opaque, with plain shading where no photo contributes to a
/// surface, and the background where there is no surface. `rendered`: the same view with transparent holes,
/// taken with `side` * `side` samples per pixel. A pixel of which only some samples have a color is completed
/// with the mean of what all its samples would show without photos.
Picture as_in_window(Renderer& renderer, const View& view, RenderSettings settings, const Picture& rendered,
                     int side);

/// Per pixel the squared difference of the window's frame from the photo, summed over three channels; 0 where
/// the photo has no pixel (`taken`). `gain` is applied to the pixels `colored`.
Plane squared_errors(const Picture& photo, const Picture& shown, const std::vector<bool>& taken,
                     const std::vector<bool>& colored, const std::array<double, 3>& gain);

/// The difference of the window's whole frame from the photo, holes included.
struct FrameScore {
    std::size_t pixels = 0;          ///< that the photo has; if 0, all other values are 0
    double psnr = 0, psnr_gain = 0;  ///< dB, as in PictureScore
    double ssim = 0, ssim_gain = 0;
};

/// `shown`: as_in_window; `taken`: the photo has the pixel; `colored`: the rendered picture does. `gain` is
/// that of the colored pixels (PictureScore::gain) and applied to them alone: shading and background have no
/// exposure. `errors`: squared_errors of the same.
FrameScore score_frame(const Picture& photo, const Picture& shown, const std::vector<bool>& taken,
                       const std::vector<bool>& colored, const std::array<double, 3>& gain,
                       const Plane& errors);

}  // namespace vantage
