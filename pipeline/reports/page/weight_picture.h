#pragma once
#include <array>
#include <cstdint>
#include <span>

#include "base/values/rgba_image.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// Name and sRGB color of what lessens a photo's weight somewhere.
struct WeightColor {
    const char *name, *meaning;
    std::array<std::uint8_t, 3> color;
};
/// Full weight, angle, depth, border, transient masking, nothing seen: the legend of weight_picture().
extern const std::array<WeightColor, 6> weight_colors;

/// The linear depth at which the nearest of the photos resolves what it sees, as pixels per unit: of the
/// median depth. 0 if none sees anything.
double best_density(std::span<const package::PhotoRecord> photos);

/// A photo's weight maps at a level of at most `longest` texels: white where the photo has its full weight,
/// otherwise the color of the weight map that lessens it most, the deeper the more. A photo is far as far as
/// its density is below `finest`. 1x1 and gray if the photo has no weight maps. Throws Error(damaged).
RgbaImage weight_picture(const PackageReader& package, std::uint32_t photo, double best, int longest);

}  // namespace vantage
