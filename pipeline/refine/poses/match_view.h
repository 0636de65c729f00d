#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <opencv2/core.hpp>
#include <span>

#include "base/values/lru_cache.h"
#include "scene/camera/camera.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// A photo at one level of its pyramid, prepared for matching.
struct MatchView {
    int level;
    Intrinsics k;   ///< of this level
    Pose pose;      ///< pose from which the depth was rendered
    cv::Mat gray;   ///< u8, normalized by local mean and contrast to be independent of exposure
    cv::Mat depth;  ///< f32, linear z; +inf if the photo does not see the model
};

/// Reads the finest level that has depth and at most `long_side` pixels on its longer side, or the coarsest
/// level if there is no such level. Throws Error(damaged).
MatchView read_match_view(const PackageReader& package, const package::PhotoRecord& record,
                          std::uint32_t photo, int long_side);

/// Views of a package's photos at the requested sizes, cached for all rounds of matching. The cache takes
/// about 50 MB for each size: 12 views of 1600 px or 48 views of 800 px. Thread-safe.
class MatchViews {
  public:
    /// `package` and `photos` must outlive this object.
    MatchViews(const PackageReader& package, std::span<const package::PhotoRecord> photos)
        : package_(package), photos_(photos) {}
    /// Throws Error(damaged).
    std::shared_ptr<const MatchView> get(std::uint32_t photo, int long_side) const;
    const PackageReader& package() const { return package_; }

  private:
    const PackageReader& package_;
    std::span<const package::PhotoRecord> photos_;
    mutable std::mutex mutex_;  ///< of `sizes_`
    mutable std::map<int, LruCache<MatchView>> sizes_;
};

/// Converts a position at a level to full-size pixels. At all levels, pixel centers are at +0.5.
inline Eigen::Vector2d at_full_size(const Eigen::Vector2d& pixel, int level) { return pixel * (1 << level); }

}  // namespace vantage
