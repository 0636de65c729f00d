#pragma once
#include <Eigen/Core>
#include <span>

#include "scene/package/contents/mesh.h"

namespace vantage {

/// Maximum number of triangles in the stand-in of a cloud.
inline constexpr std::size_t max_facets = 32768;

/// A coarse mesh that represents a cloud where a mesh is needed: to choose photos and tiles, and to compare
/// photos. Each occupied cell of a grid gets one triangle; the grid is the finest with at most `max_facets`
/// occupied cells. The triangle is centered on the mean of the cell's points, lies in the best-fitting plane
/// of the points in the cells around it (Hoppe et al. 1992), and is large enough to cover the cell. The
/// triangle faces the nearest of `eyes` or, without eyes, away from the center of the cloud. `cloud` must
/// have at least one point, and finite positions. Deterministic.
Mesh stand_in(const Mesh& cloud, std::span<const Eigen::Vector3d> eyes);

/// The edge length of a stand-in's triangles, from their corners; 0 without triangles.
double facet_size(std::span<const Eigen::Vector3f> positions, std::span<const std::uint32_t> indices);

}  // namespace vantage
