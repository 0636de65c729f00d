#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <optional>
#include <span>

#include "scene/camera/camera.h"

namespace vantage {

/// The longer side of a camera's photo, in px.
double longer_side(const Camera& camera);

/// Rays of the original photos, including the lens; caches the valid ranges of the lenses. Not thread-safe.
class PhotoRays {
  public:
    /// `cameras` has one camera per photo and must outlive this object.
    explicit PhotoRays(std::span<const Camera> cameras) : cameras_(cameras) {}

    /// Normalized pinhole coordinates of a pixel; empty beyond the lens's valid range.
    std::optional<Eigen::Vector2d> pinhole(std::uint32_t photo, const Eigen::Vector2d& pixel);

  private:
    std::span<const Camera> cameras_;
    std::map<std::uint32_t, double> ranges_;
};

/// The pixel at which a camera, including its lens, images a point; empty behind the camera.
std::optional<Eigen::Vector2d> imaged(const Camera& camera, const Eigen::Vector3d& point);

}  // namespace vantage
