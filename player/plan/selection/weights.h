#pragma once
#include <vector>

#include "player/view/view.h"
#include "scene/package/package_format.h"
#include "shaders/contract.h"

namespace vantage {

/// The enabled weights, and their parameters.
struct WeightSettings {
    bool distance = true;  ///< [M]: from viewpoint to camera center, relative to the other photos
    bool angle = true;  ///< between rays at the surface; with `angle_per_photo`, between viewing directions
    bool angle_per_photo = false;
    bool angle_weight = true, depth_weight = true, border_weight = true, transient_mask = true;
    bool fov_normalization = false;  ///< compare distances as if all fields of view were equal [M] 4.1 to 4.3
    bool corrected_directions = false;  ///< [P]: a photo's direction points to the center of its visible area
    double exponent = 2;                ///< exponent of the distance and per-photo angle weights
    double sharpness =
        shader::default_sharpness;  ///< radians: the angle between rays at which the weight is 1/e
    bool operator==(const WeightSettings&) const = default;
};

/// The weights are 1 for the smallest value and decrease linearly to `floor` for the largest; if all values
/// are equal, all weights are 1. Values must be finite. A range below `indistinct` is considered rounding
/// error and treated as `indistinct`.
std::vector<double> nearest_is_one(const std::vector<double>& values, double floor = 1e-3,
                                   double indistinct = 0);

/// The factors of the photos' dynamic weights, one value in (0, 1] per photo: `distance` is 1 for the nearest
/// photo, and `angle` is 1 for the photo with the most similar direction.
struct ViewWeights {
    std::vector<double> distance, angle;
};
ViewWeights view_weights(const View& view, std::span<const package::PhotoRecord> photos,
                         const WeightSettings& settings);

/// Dynamic weight of each photo for a view, in [1e-9, 1].
std::vector<double> dynamic_weights(const View& view, std::span<const package::PhotoRecord> photos,
                                    const WeightSettings& settings);

}  // namespace vantage
