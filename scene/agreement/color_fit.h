#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "scene/agreement/shared_discs.h"
#include "scene/camera/camera.h"
#include "scene/package/package_format.h"

namespace vantage {

/// The coefficients of the logarithm of the factor that compensates for a lens's vignetting: f0 r^2 + f1 r^4
/// + f2 r^6, with r = 1 at half the diagonal.
using Vignetting = std::array<double, 3>;
/// The radius r of a pixel: its distance from the principal point, divided by half the photo's diagonal.
double vignetting_radius(const Intrinsics& intrinsics, const Eigen::Vector2d& pixel);
double log_vignetting(const Vignetting& vignetting, double radius);
double log_vignetting_at_square(const Vignetting& vignetting, double radius2);

/// Converts a difference of natural logarithms to percent.
inline double percent(double ln) { return 100 * std::expm1(ln); }

/// The gains and the vignetting that make photos of the same surface agree in the value of ln I +
/// ln_gain[photo][channel] + log_vignetting(vignetting[lens], r).
struct ColorFit {
    std::vector<std::array<double, 3>> ln_gain;  ///< per photo; the mean over a component is 0
    std::vector<Vignetting> vignetting;          ///< per lens
    std::vector<std::uint32_t>
        component;  ///< per photo: the number of its component, a group of photos connected by shared surface
    std::vector<std::size_t> samples;  ///< per photo: discs that another photo also shows
    /// The median |ln ratio| between photos of the same disc, averaged over the channels, without and with
    /// the correction.
    double before = 0, after = 0;
    std::vector<double> photo_before,
        photo_after;  ///< the same medians for each photo; 0 if the photo shares no disc

    /// Whether any photos have enough surface in common to be compared.
    bool shares_surface() const {
        return std::ranges::any_of(samples, [](std::size_t n) { return n > 0; });
    }
};

/// The number of each photo's lens, counted from 0. Photos share a lens if they have the same size, in either
/// orientation, and the same focal length to within 0.5 %, unless they belong to different image sets.
std::vector<std::uint32_t> lenses_of(std::span<const package::PhotoRecord> photos);

/// A least-squares fit over all discs that several photos show; the discs' colors are eliminated. Residuals e
/// are iteratively reweighted by 1 / (1 + (e / s)^2) (Cauchy). The scale s starts at 0.6, so that photos two
/// stops apart are not outliers, and ends at 0.12. A photo with fewer than 30 shared discs keeps gain 1; all
/// gains are from 1/4 to 4. Vignetting is fitted for lenses with at least three photos. The vignetting is
/// kept if the light loss grows outward, reaches 5 to 60 % in the corner, and lowers the cost by at least 2
/// %. `lens`: per photo.
ColorFit fit_colors(Samples samples, std::span<const std::uint32_t> lens, bool with_vignetting);

/// Gains and vignetting per photo.
struct PhotoColors {
    std::vector<std::array<double, 3>> ln_gain;
    std::vector<Vignetting> vignetting;
};
PhotoColors colors_of(const ColorFit& fit, std::span<const std::uint32_t> lens);

/// The gains and vignetting of all photos, fitted without `photo`, whose own gain is 1 and whose vignetting
/// is that of its lens.
PhotoColors fit_without(Samples samples, std::span<const std::uint32_t> lens, std::uint32_t photo,
                        bool with_vignetting);

/// The results of fit_without() with gains alone and with both gains and vignetting.
struct FitsWithout {
    PhotoColors gains, both;
};
FitsWithout fits_without(Samples samples, std::span<const std::uint32_t> lens, std::uint32_t photo);

/// Writes gains and vignetting to the photos' records. A disabled gain is written as 1, disabled vignetting
/// as 0.
void apply_colors(const PhotoColors& colors, bool gains_on, bool vignetting_on,
                  std::span<package::PhotoRecord> photos);

}  // namespace vantage
