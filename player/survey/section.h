#pragma once
#include <Eigen/Core>
#include <array>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "player/plan/section_plane.h"
#include "player/survey/ray_cast.h"
#include "player/survey/scene_point.h"

namespace vantage {

/// Where planes cut the surface that is behind all others of them: one line for each triangle that a plane
/// cuts, relative to the scene's origin. A corner on a plane counts as behind it, so that a line through a
/// corner has no gap. The background is not cut.
using SectionLine = std::array<Eigen::Vector3d, 2>;
std::vector<SectionLine> section_lines(std::span<const PlacedMesh> meshes,
                                       std::span<const SectionPlane> planes);

/// A drawing (DXF, release 12) of the lines in coordinates of the input, whose origin is `origin`.
std::string section_dxf(std::span<const SectionLine> lines, const Eigen::Vector3d& origin);

/// The part of a ray behind all planes; empty (nearest > farthest) if there is none.
RayRange behind(std::span<const SectionPlane> planes, const Ray& ray);

/// The lowest and the highest value of normal . p of the mesh's vertices; background has no part in it.
std::array<double, 2> extent_along(const PlanScene& scene, const Eigen::Vector3d& normal);

/// extent_along() of one scene, found once per direction: of a level floor, it looks at all vertices.
class KnownExtents {
  public:
    std::array<double, 2> along(const PlanScene& scene, const Eigen::Vector3d& normal);

  private:
    static constexpr std::size_t most = 8;  ///< the input's axes, and views that the model was cut across
    std::vector<std::pair<Eigen::Vector3d, std::array<double, 2>>> known_;
};

}  // namespace vantage
