#pragma once
#include <vector>

#include "player/view.h"
#include "scene/package_format.h"

namespace vantage {

/// Which weights take part, and how sharply.
struct WeightSettings {
    bool distance = true;  ///< [M]: viewpoint to camera centre, over the photos
    bool angle = true;     ///< between rays at the surface, or with `angle_per_photo` between view directions
    bool angle_per_photo = false;
    bool angle_mask = true, depth_mask = true, border_mask = true, consensus_mask = true;
    bool fov_normalisation = false;     ///< [M] 4.1 to 4.3
    bool corrected_directions = false;  ///< [P]: photos look at the middle of what they see
    double exponent = 2;                ///< of distance and per-photo angle
    double sharpness = 0.055;           ///< radians: the angle between rays at which a photo counts 1/e
};

/// 1 for the least value, falling linearly to `floor` for the greatest; all equal: all 1. Values finite.
/// Differences that are small beside `indistinct` are rounding and hardly count.
std::vector<double> nearest_is_one(const std::vector<double>& values, double floor = 1e-3,
                                   double indistinct = 0);

/// What a photo's dynamic weight is made of, each in (0, 1]: 1 for the nearest, and for the one that looks
/// the same way.
struct ViewWeights {
    std::vector<double> distance, angle;
};
ViewWeights view_weights(const View& view, std::span<const package::PhotoRecord> photos,
                         const WeightSettings& settings);

/// Dynamic weight of each photo for a view, in (0, 1].
std::vector<double> dynamic_weights(const View& view, std::span<const package::PhotoRecord> photos,
                                    const WeightSettings& settings);

}  // namespace vantage
