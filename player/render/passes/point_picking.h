#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/gl/readback.h"
#include "player/render/passes/point_pass.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// A point of the cloud as stored in the package.
struct PickedPoint {
    Eigen::Vector3d position;           ///< in input coordinates
    std::array<std::uint8_t, 3> color;  ///< sRGB
};

/// The point that has this `number` (see PointPass::numbers()) if `nodes` are drawn; nullopt for 0 and
/// invalid numbers.
std::optional<PickedPoint> point_numbered(const PackageReader& package, const PointCloud& cloud,
                                          std::span<const DrawnNode> nodes, std::uint32_t number);

/// Finds the point at a pixel of the last frame. Its number is read back asynchronously, so the answer
/// arrives a few calls later. Must be used on the OpenGL thread.
class PointPicking {
  public:
    /// Receives the pending answer if it has arrived, and requests the point at `pixel`, counted from the
    /// frame's upper left.
    void look(const PackageReader& package, const PointPass& points, const Eigen::Vector2i& pixel, int width,
              int height);
    /// The last answer.
    const std::optional<PickedPoint>& found() const { return found_; }

  private:
    void take(const PackageReader& package, const PointPass& points);

    gl::Readback number_;
    std::vector<DrawnNode> nodes_;  ///< drawn when the pending answer was requested
    std::optional<PickedPoint> found_;
};

}  // namespace vantage
