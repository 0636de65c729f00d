#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/align/neighboring_photos.h"

namespace vantage {

/// A feature visible in two photos; positions are in full-size pixels of the photos as taken.
struct SharedFeature {
    std::uint32_t a, b;  ///< photos, a < b
    Eigen::Vector2d in_a, in_b;
};

/// Settings for feature detection.
struct FeatureSettings {
    int long_side = 480;   ///< longer side of the reduced photos, px
    int features = 1000;   ///< maximum number of features per photo
    unsigned threads = 0;  ///< 0: all cores
};

/// SIFT features (Lowe 2004) of the photos in `pairs`, matched in both directions with a ratio of 0.8. Does
/// not use the cameras. A photo that cannot be decoded has no features. Deterministic.
std::vector<SharedFeature> shared_features(std::span<const PhotoInput> photos,
                                           std::span<const TwoPhotos> pairs, const FeatureSettings& how);

}  // namespace vantage
