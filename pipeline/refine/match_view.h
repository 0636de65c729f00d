#pragma once
#include <cstdint>
#include <opencv2/core.hpp>

#include "scene/camera.h"
#include "scene/package_reader.h"

namespace vantage {

/// A photo at one level of its pyramid, prepared for matching.
struct MatchView {
    int level;
    Intrinsics k;   ///< of this level
    Pose pose;      ///< from which the depth was rendered
    cv::Mat gray;   ///< u8, normalized by local mean and contrast, independent of exposure
    cv::Mat depth;  ///< f32, linear z; +inf if the photo does not see the model
};

/// Reads the finest level that has depth and at most `long_side` pixels on its longer side, or the coarsest.
/// Throws Error(damaged).
MatchView read_match_view(const PackageReader& package, const package::PhotoRecord& record,
                          std::uint32_t photo, int long_side);

/// Converts a position at a level to full-size pixels. Pixel centers are at +0.5 at all levels.
inline Eigen::Vector2d at_full_size(const Eigen::Vector2d& pixel, int level) { return pixel * (1 << level); }

}  // namespace vantage
