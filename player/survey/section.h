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

/// The lines along which planes cut the surface, limited to the part that remains after the other planes'
/// cuts: one line per intersected triangle, relative to the scene's origin. A vertex on a plane counts as
/// behind the plane, so that a line through a vertex has no gap. The background is not cut. If triangles are
/// counterclockwise as seen from outside, (line[1] - line[0]) x the plane's normal points outward.
using SectionLine = std::array<Eigen::Vector3d, 2>;
std::vector<SectionLine> section_lines(std::span<const PlacedMesh> meshes,
                                       std::span<const SectionPlane> planes);
/// The lines along which one plane cuts the surface that remains after the cuts of `others`.
std::vector<SectionLine> lines_in(std::span<const PlacedMesh> meshes, const SectionPlane& plane,
                                  std::span<const SectionPlane> others);

/// A drawing (DXF, release 12) of the lines in input coordinates, relative to `origin`.
std::string section_dxf(std::span<const SectionLine> lines, const Eigen::Vector3d& origin);

/// The part of a ray behind all planes; empty (nearest > farthest) if there is none.
RayRange behind(std::span<const SectionPlane> planes, const Ray& ray);

/// The minimum and maximum of normal . p over the mesh's vertices p, without the background.
std::array<double, 2> extent_along(const PlanScene& scene, const Eigen::Vector3d& normal);

/// Caches the result of extent_along() for each direction in one scene, since that function visits all
/// vertices.
class KnownExtents {
  public:
    std::array<double, 2> along(const PlanScene& scene, const Eigen::Vector3d& normal);

  private:
    static constexpr std::size_t most = 8;  ///< enough for the input's axes and some viewing directions
    std::vector<std::pair<Eigen::Vector3d, std::array<double, 2>>> known_;
};

}  // namespace vantage
