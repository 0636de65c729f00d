#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/background/backdrop.h"

namespace vantage {

/// How each direction of a backdrop is painted, see docs/method.md.
struct BackdropPaint {
    static constexpr std::uint8_t none = 255;
    std::vector<std::uint8_t> view;  ///< index of the view that shows it; none
    std::vector<Eigen::Array3f>
        correction;            ///< of that view's color, which hides seams; square roots of light
    std::vector<float> trust;  ///< 0 to 1: falls to 0 where no view shows anything
};

/// Chooses one view per direction by graph cuts (alpha expansion, Boykov et al. 2001; seams as Agarwala et
/// al. 2004), and smooth corrections that continue colors across seams. At most 254 views.
BackdropPaint paint_backdrop(const Backdrop& backdrop, std::span<const CoarseView> views, unsigned threads);

}  // namespace vantage
