#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "base/values/grid.h"
#include "scene/agreement/color_fit.h"
#include "scene/camera/camera.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// The color and depth of a photo at a coarse level.
struct TransientView {
    int width = 0, height = 0;
    Intrinsics k;  ///< intrinsics at this level
    Pose pose;     ///< relative to the origin
    struct Texel {
        float ln[3];            ///< natural logarithm of linear light; NaN if the photo has no pixel
        float low[3], high[3];  ///< range of `ln` over the 3x3 texels around this one
        float z;                ///< +inf if the photo does not see the model
    };
    std::vector<Texel> texels;  ///< row by row

    Grid<const Texel> grid() const { return {texels.data(), width, height}; }
};
/// Sets a texel's depth and its uncorrected color, given in linear light (NaN: the photo has no pixel). Call
/// find_ranges() afterwards.
void set_color(TransientView::Texel& texel, const float* linear, float z);
/// Computes `low` and `high` of all texels from their colors.
void find_ranges(TransientView& view);

/// The level at which photos are compared for transient masks, with at most 512 texels on the longer side.
int transient_level(const package::PhotoRecord& record);
/// A photo's pixels at a level that has weight maps, with uncorrected colors. Throws Error(damaged).
TransientView read_transient_view(const PackageReader& package, const package::PhotoRecord& record,
                                  std::uint32_t photo, int level);

/// The view converted to the mean photo's exposure, with vignetting corrected.
TransientView corrected(TransientView view, const std::array<double, 3>& ln_gain,
                        const Vignetting& vignetting);

}  // namespace vantage
