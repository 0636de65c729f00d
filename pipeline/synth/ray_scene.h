#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "scene/mesh.h"

namespace vantage {

/// Where a ray meets a mesh first.
struct RayHit {
    std::uint32_t triangle;
    double distance;     ///< in units of the direction's length
    Eigen::Vector2d uv;  ///< barycentric, of the triangle's second and third vertex
};

/// Ray casting by Embree, of robust traversal, independent of OpenGL. Thread-safe. Positions are single
/// precision about the mesh's first vertex's neighbourhood: meant for scenes near the origin.
class RayScene {
  public:
    /// Both copy. Throw Error(memory) if the mesh does not fit in memory, std::runtime_error if Embree fails.
    explicit RayScene(const Mesh& mesh);
    RayScene(std::span<const Eigen::Vector3f> positions, std::span<const std::uint32_t> indices);
    ~RayScene();
    RayScene(RayScene&&) noexcept;

    std::optional<RayHit> first_hit(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                                    double nearest = 0) const;
    /// Anything between the shares `nearest` and `farthest` of the direction.
    bool occluded(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, double nearest,
                  double farthest) const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace vantage
