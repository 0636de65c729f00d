#pragma once
#include <cstdint>
#include <opencv2/core.hpp>

#include "scene/camera.h"
#include "scene/package_reader.h"

namespace vantage {

/// A photo as it is matched with others, at one level of its pyramid.
struct MatchView {
    int level;
    Intrinsics k;   ///< of this level
    Pose pose;      ///< that the depth was rendered from
    cv::Mat grey;   ///< u8, less its local mean and over its local contrast, so that exposure does not matter
    cv::Mat depth;  ///< f32, linear z; +inf where the photo does not see the model
};

/// From the photo's tiles and depth: the finest level that has depth and at most `long_side` pixels along its
/// longer side, or the coarsest. Throws Error(damaged).
MatchView read_match_view(const PackageReader& package, const package::PhotoRecord& record,
                          std::uint32_t photo, int long_side);

/// Full pixels for pixels of a level: centres stay centres.
inline Eigen::Vector2d at_full_size(const Eigen::Vector2d& pixel, int level) { return pixel * (1 << level); }

}  // namespace vantage
