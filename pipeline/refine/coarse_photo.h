#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/values/grid.h"
#include "scene/agreement/read_level.h"
#include "scene/camera/camera.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// Relative depth difference above which texels are considered to be on different surfaces.
inline constexpr double depth_step = 0.02;

/// Mean colors of the 2 x 2 texels around each texel corner; at the edge of the photo, only texels inside the
/// photo count. Interpolating between four corners gives the mean over a square at any position.
struct SquareMeans {
    int width = 0, height = 0;           ///< in corners; one more than the number of texels
    std::vector<Eigen::Array4f> colors;  ///< row by row, in linear light; the fourth value is unused

    /// The mean around a position in units of squares. Each coordinate must be at least 0 and at most one
    /// square beyond the last.
    Eigen::Array4f around(float x, float y) const;
};

/// `colors`: the colors of a level, in row-major order.
SquareMeans square_means(std::span<const std::array<float, 3>> colors, int width, int height);

/// A photo at one coarse level of its pyramid, for validation.
struct CoarsePhoto {
    struct Texel {
        float linear[3];  ///< light as exposed; NaN where the photo has no opaque pixel
        float smooth[3];  ///< for seams: mean of `linear` over those of 9 x 9 texels that show the model
        float z;          ///< +inf where the photo does not see the model
        float weight;     ///< the product of the lumigraph's factors for frame and borders
    };
    Intrinsics k;               ///< of this level
    Pose pose;                  ///< relative to the origin
    double focal = 1;           ///< focal length, in px of the full-size photo
    std::vector<Texel> texels;  ///< row by row
    /// Means of the next finer level. Their squares are as large as this level's texels; they are used
    /// because interpolation between coarse texels would blur.
    SquareMeans means;

    Grid<const Texel> grid() const { return {texels.data(), k.width, k.height}; }
};

/// Every second texel in x and in y, that is, the same photo with a quarter of its rays. The result has no
/// `means`.
CoarsePhoto every_second_texel(const CoarsePhoto& photo);

/// Reads a photo's tiles, weight maps and depth at a level. Throws Error(damaged).
CoarsePhoto read_coarse_photo(const PackageReader& package, const package::PhotoRecord& record,
                              std::uint32_t photo, int level);

}  // namespace vantage
