#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "player/render/picture.h"

namespace vantage {

/// How far a rendered picture is from the photo, over the pixels that are scored.
struct PictureScore {
    std::size_t pixels = 0;  ///< scored; all else is 0 where there is none
    double psnr = 0;         ///< dB, 10 log10(255^2 / mean squared difference) over three channels
    double psnr_gain =
        0;  ///< the same, the picture times the gain a channel that fits best: exposure does not count
    double ssim = 0;  ///< of luminance (Wang et al. 2004), windows normalised to the scored pixels
    double sharpness =
        0;  ///< energy of luminance above half the Nyquist frequency, over the photo's; 0 without any
    double worst = 0;  ///< grey levels by which the worst 0.1 % of the pixels are off, or more; after gains
    std::array<double, 3> gain{1, 1, 1};
};

/// Pixels whose alpha is at least one half, but for those within `radius` of one that is not (the frame's
/// edge does not count as one).
std::vector<bool> scored_pixels(const Picture& picture, int radius = 3);

/// Both pictures have the same size, and `scored` a flag a pixel.
PictureScore score(const Picture& photo, const Picture& picture, const std::vector<bool>& scored);

/// By how many pixels the picture's content lies to the right of and below the photo's: least squares over
/// the gradients (Lucas and Kanade 1981), after gains; {0, 0} where there is nothing to go by. For shifts of
/// a few pixels.
std::array<double, 2> shift_of(const Picture& photo, const Picture& picture, const std::vector<bool>& scored);

/// The largest difference of a pixel's channels, gains applied, as a picture from black over red to white (at
/// a quarter of the range).
Picture difference_picture(const Picture& photo, const Picture& picture, const PictureScore& score);

}  // namespace vantage
