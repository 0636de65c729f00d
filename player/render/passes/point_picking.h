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

/// A point of the cloud as the package has it.
struct PickedPoint {
    Eigen::Vector3d position;           ///< in the input's coordinates
    std::array<std::uint8_t, 3> color;  ///< its own, sRGB
};

/// The point that `number` stands for (PointPass::numbers()), with `nodes` drawn; nothing for 0, and for
/// numbers of no point.
std::optional<PickedPoint> point_numbered(const PackageReader& package, const PointCloud& cloud,
                                          std::span<const DrawnNode> nodes, std::uint32_t number);

/// Finds the point at a pixel of the frame that was drawn last. Its number is read back without waiting for
/// the graphics card, so that the answer comes a few calls later. Belongs to the OpenGL thread.
class PointPicking {
  public:
    /// Takes up an answer that has arrived, and asks for the point at `pixel` (from the frame's upper left).
    void look(const PackageReader& package, const PointPass& points, const Eigen::Vector2i& pixel, int width,
              int height);
    /// The last answer.
    const std::optional<PickedPoint>& found() const { return found_; }

  private:
    void take(const PackageReader& package, const PointPass& points);

    gl::Readback number_;
    std::vector<DrawnNode> nodes_;  ///< drawn when the answer under way was asked for
    std::optional<PickedPoint> found_;
};

}  // namespace vantage
