#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/agree/shared_discs.h"
#include "scene/package_format.h"

namespace vantage {

/// ln of what a lens loses towards the corner: f0 r^2 + f1 r^4 + f2 r^6, r = 1 at half the diagonal.
using Falloff = std::array<double, 3>;
double log_falloff(const Falloff& falloff, double radius);

/// A difference of logarithms as people read it.
inline double percent(double ln) { return 100 * std::expm1(ln); }

/// What makes the photos of one surface agree: ln I + ln_gain[photo][channel] + log_falloff(lens, r).
struct ColorFit {
    std::vector<std::array<double, 3>> ln_gain;  ///< a photo; their mean over a component is 0
    std::vector<Falloff> falloff;                ///< a lens
    std::vector<std::uint32_t> component;        ///< a photo: photos that share surface have one number
    std::vector<std::size_t> samples;            ///< a photo: discs that another photo shows, too
    double before = 0, after = 0;  ///< median of |ln ratio| between photos of one disc, mean of channels
    /// Some photos show enough of one surface.
    bool shares_surface() const {
        return std::ranges::any_of(samples, [](std::size_t n) { return n > 0; });
    }
    std::vector<double> photo_before, photo_after;  ///< the same of pairs with one photo; 0 without any
};

/// Which lens took each photo: those of one size and focal length (to 0.5 %) share one. Counted from 0.
std::vector<std::uint32_t> lenses_of(std::span<const package::PhotoRecord> photos);

/// Least squares over all discs that several photos show, their own colours eliminated; robust by iterated
/// weights 1/(1 + (e/0.12)^2) (Cauchy), begun wide, so that photos two stops apart are no outliers. A photo
/// with fewer than 30 such discs keeps gain 1; gains are within 4. A lens of three photos or more has a
/// falloff only where it grows outwards, is 5 to 60 % in the corner, and lowers the cost by 2 %. `samples`: a
/// photo's discs, or none.
ColorFit fit_colors(Samples samples, std::span<const std::uint32_t> lens, bool with_falloff);

}  // namespace vantage
