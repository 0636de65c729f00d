#pragma once
#include <Eigen/Core>
#include <memory>

#include "scene/package/contents/mesh.h"

namespace vantage {

/// The nearest point on a surface or in a cloud.
struct NearestPoint {
    Eigen::Vector3d point, normal;  ///< the normal is not normalized; zero in a cloud without normals
    double distance;

    /// Whether the normal points away from `at`, whose nearest point this is.
    bool is_behind(const Eigen::Vector3d& at) const { return normal.dot(at - point) < 0; }
};

/// A mesh's triangles, or a cloud's points, for nearest-point queries (Embree). Boxes have single precision
/// and are relative to the first vertex; distances have double precision. Thread-safe.
class NearestSurface {
  public:
    /// `mesh` must have a vertex and outlive this object. Throws Error(memory).
    explicit NearestSurface(const Mesh& mesh);
    ~NearestSurface();
    NearestSurface(NearestSurface&&) noexcept;

    /// On edges and at corners, where several triangles are nearest, the normal is the sum of the triangles'
    /// normals, weighted by angle (Baerentzen and Aanaes 2005).
    NearestPoint nearest(const Eigen::Vector3d& at) const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace vantage
