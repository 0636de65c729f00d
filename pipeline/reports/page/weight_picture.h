#pragma once
#include <array>
#include <cstdint>
#include <span>

#include "base/values/rgba_image.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// The name, meaning and sRGB color of a cause that lowers a photo's weight.
struct WeightColor {
    const char *name, *meaning;
    std::array<std::uint8_t, 3> color;
};
/// The legend of weight_picture(): full weight, angle, depth, border, transient masking, nothing seen.
extern const std::array<WeightColor, 6> weight_colors;

/// The finest resolution of any photo at its median depth, in pixels per unit; 0 if no photo sees the model.
double best_density(std::span<const package::PhotoRecord> photos);

/// A photo's weight maps at a level of at most `longest` texels. White means full weight. Elsewhere, the
/// picture has the color of the weight map that lowers the weight most. The lower the weight, the deeper the
/// color. A photo counts as distant to the extent that its density is below `best`. The picture is 1x1 and
/// gray if the photo has no weight maps. Throws Error(damaged).
RgbaImage weight_picture(const PackageReader& package, std::uint32_t photo, double best, int longest);

}  // namespace vantage
