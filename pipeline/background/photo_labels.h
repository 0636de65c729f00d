#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/background/backdrop.h"

namespace vantage {

/// The color source of each direction of a backdrop; see docs/method.md.
struct BackdropPaint {
    static constexpr std::uint8_t none = 255;
    std::vector<std::uint8_t> view;  ///< index of the view that shows the direction, or `none`
    /// Correction added to the view's color to hide seams, in square roots of light.
    std::vector<Eigen::Array3f> correction;
    std::vector<float> trust;  ///< 0 to 1: falls to 0 in unseen directions
};

/// Chooses one view per direction by graph cuts (alpha expansion, Boykov et al. 2001; seams as in Agarwala et
/// al. 2004), and smooth corrections that match colors across seams. The number of views is limited to 254.
BackdropPaint paint_backdrop(const Backdrop& backdrop, std::span<const CoarseView> views, unsigned threads);

}  // namespace vantage
