#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "scene/camera.h"
#include "scene/package_reader.h"
#include "values/grid.h"

namespace vantage {

/// A photo at one coarse level of its pyramid, as the judge reads it.
struct CoarsePhoto {
    struct Texel {
        float linear[3];  ///< light, as exposed; NaN where the photo has no opaque pixel
        float smooth[3];  ///< mean of `linear` over the surface around it, 9 x 9 texels; for seams
        float z;          ///< +inf where the photo does not see the model
        float weight;     ///< the part of the lumigraph's weight that does not depend on the viewer
    };
    Intrinsics k;               ///< of this level
    Pose pose;                  ///< relative to the origin
    std::vector<Texel> texels;  ///< row by row
    /// Linear light at the next finer level: a color there is averaged around its exact position, which
    /// interpolation between coarse texels would blur.
    std::vector<std::array<float, 3>> fine;
    int fine_width = 0, fine_height = 0;

    Grid<const Texel> grid() const { return {texels.data(), k.width, k.height}; }
};

/// The finest level with at most `long_side` texels on its longer side that has masks, or the coarsest.
int coarse_level(const package::PhotoRecord& record, int long_side);

/// Reads a photo's tiles, masks and depth at a level. Throws Error(damaged).
CoarsePhoto read_coarse_photo(const PackageReader& package, const package::PhotoRecord& record,
                              std::uint32_t photo, int level, double border_width);

}  // namespace vantage
