#pragma once
#include <array>
#include <cstdint>
#include <span>

#include "base/values/rgba_image.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// Name and sRGB color of what lessens a photo's weight somewhere.
struct MaskColor {
    const char *name, *meaning;
    std::array<std::uint8_t, 3> color;
};
/// Full weight, angle, depth, border, transient masking, nothing seen: the legend of mask_picture().
extern const std::array<MaskColor, 6> mask_colors;

/// The linear depth at which the nearest of the photos resolves what it sees, as pixels per unit: of the
/// median depth. 0 if none sees anything.
double best_density(std::span<const package::PhotoRecord> photos);

/// A photo's masks at a level of at most `longest` texels: white where the photo has its full weight,
/// otherwise the color of the mask that lessens it most, the deeper the more. A photo is far as far as its
/// density is below `finest`. 1x1 and gray if the photo has no masks. Throws Error(damaged).
RgbaImage mask_picture(const PackageReader& package, std::uint32_t photo, double best, int longest);

}  // namespace vantage
