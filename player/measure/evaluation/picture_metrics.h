#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "player/render/picture.h"

namespace vantage {

/// The difference of a rendered picture from the photo, over the scored pixels.
struct PictureScore {
    std::size_t pixels = 0;  ///< compared pixels; if 0, all other values are 0
    double psnr = 0;         ///< dB, 10 log10(255^2 / mean squared difference) over three channels
    double psnr_gain = 0;    ///< PSNR after the best gain per channel, independent of exposure
    double ssim = 0;       ///< SSIM of luminance (Wang et al. 2004); windows normalized to the scored pixels
    double ssim_gain = 0;  ///< SSIM after the gain of psnr_gain, rounded to 8 bits
    /// Energy of luminance above half the Nyquist frequency, relative to the photo's; 0 if the photo has
    /// none.
    double sharpness = 0;
    double worst = 0;  ///< gray levels, after gains: the worst 0.1 % of the pixels differ by this or more
    std::array<double, 3> gain{1, 1, 1};
};

/// Pixels with an alpha of at least one half, eroded by `radius` (the frame's edge does not erode).
std::vector<bool> scored_pixels(const Picture& picture, int radius = 3);

/// The gain per channel that minimizes the squared difference between the picture's scored pixels and the
/// photo's; 1 if no pixel is scored. Here and below, both pictures have the same size, and there is one flag
/// per pixel.
std::array<double, 3> fitted_gain(const Picture& photo, const Picture& picture,
                                  const std::vector<bool>& scored);

/// PSNR in dB for a sum of squared differences over three channels; `pixels` > 0. At most 168 dB.
double psnr_of(double squares, std::size_t pixels);

/// PSNR in dB after the given gain, over the scored pixels; 0 if there are none.
double psnr_after(const std::array<double, 3>& gain, const Picture& photo, const Picture& picture,
                  const std::vector<bool>& scored);

/// The picture with the gain applied to the pixels flagged in `where`, rounded and clipped to 8 bits.
Picture gained(Picture picture, const std::array<double, 3>& gain, const std::vector<bool>& where);

/// Mean SSIM over the scored pixels, see PictureScore::ssim; 0 if there are none.
double mean_ssim(const Picture& photo, const Picture& picture, const std::vector<bool>& scored);

PictureScore score(const Picture& photo, const Picture& picture, const std::vector<bool>& scored);

/// The shift of the picture's content relative to the photo's, in pixels to the right and down: least squares
/// over the gradients (Lucas and Kanade 1981), after gains; {0, 0} if there are not enough gradients. Only
/// valid for shifts of a few pixels.
std::array<double, 2> shift_of(const Picture& photo, const Picture& picture, const std::vector<bool>& scored);

/// The largest difference over each pixel's channels, after gains, as colors from black through red and
/// yellow to white (a quarter of the range or more).
Picture difference_picture(const Picture& photo, const Picture& picture, const PictureScore& score);

}  // namespace vantage
