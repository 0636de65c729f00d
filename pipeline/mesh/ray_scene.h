#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "scene/package/contents/mesh.h"

namespace vantage {

/// The first intersection of a ray with a mesh.
struct RayHit {
    std::uint32_t triangle;
    double distance;     ///< in multiples of the direction's length
    Eigen::Vector2d uv;  ///< barycentric coordinates of the triangle's second and third vertices
};

/// Casts rays with Embree (robust traversal), independently of OpenGL. Thread-safe. Positions are rounded to
/// single precision, so the scene should be near the origin.
class RayScene {
  public:
    /// Both constructors copy the mesh. Both throw Error(memory) if the mesh is too large, and
    /// std::runtime_error if Embree fails.
    explicit RayScene(const Mesh& mesh);
    RayScene(std::span<const Eigen::Vector3f> positions, std::span<const std::uint32_t> indices);
    ~RayScene();
    RayScene(RayScene&&) noexcept;

    /// The first hit at a distance of at least `nearest`, in multiples of the direction's length.
    std::optional<RayHit> first_hit(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                                    double nearest = 0) const;
    /// Whether anything is hit from `nearest` to `farthest`, in multiples of the direction's length.
    bool occluded(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, double nearest,
                  double farthest) const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace vantage
