#pragma once
#include <array>
#include <cstdint>
#include <opencv2/core.hpp>
#include <span>

#include "pipeline/refine/poses/sightings.h"

namespace vantage {

/// One way to correct and weight the other photos. Each span has one element per photo of the scene, or is
/// empty if the correction is not applied.
struct Alternative {
    std::span<const std::array<double, 3>> ln_gain{};
    std::span<const std::array<double, 3>> vignetting{};     ///< see ColorFit
    std::span<const Grid<const std::uint8_t>> transients{};  ///< one value per texel; 255: not contradicted
    std::array<double, 3> view_vignetting{};                 ///< vignetting of the predicted photo's lens
};

/// A photo predicted from the others.
struct Prediction {
    cv::Mat color;     ///< 32FC3, sRGB codes 0 to 255, R G B; NaN where no other photo sees the surface
    double seams = 0;  ///< in gray levels, see predict()
};

/// Blends the sightings as shaders/blend.frag does for the lumigraph.
///
/// `seams` measures color steps that are caused by the weights and not by the subject. The surface at each of
/// two neighboring pixels is also blended with the weights of the other pixel, and the difference is the
/// visible step. `seams` is the mean of these steps over neighbors on one surface, for smoothed colors. It
/// includes patches of different exposure, but not fine detail that photos show in slightly different places.
Prediction predict(const CoarsePhoto& target, const Sightings& sightings, const Alternative& alternative);

/// A photo's own colors in the form of a prediction.
cv::Mat own_color(const CoarsePhoto& photo);

/// The difference between a prediction and the photo over the scored pixels.
struct ValidationScore {
    std::size_t pixels = 0;  ///< number of scored pixels; if 0, the other values are 0
    double psnr = 0;         ///< PSNR in dB, after the best gain per channel
    double ssim = 0;         ///< SSIM of luminance, after the same gains
    double seams = 0;        ///< see predict
};

/// Scores predictions of one photo on the pixels that all predictions color, except for a border of 3 pixels,
/// as in player/measure.
std::vector<ValidationScore> score(const cv::Mat& own, std::span<const Prediction> predictions);

}  // namespace vantage
