#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <vector>

#include "player/view/view.h"
#include "scene/package/contents/point_cloud.h"

namespace vantage {

/// The nodes of a cloud that a view needs, each after its parent, most urgent first. The most urgent nodes
/// are those with the largest point spacing in the picture, that is, the nearest and coarsest nodes.
struct PointPlan {
    std::vector<std::uint32_t> nodes;
    std::uint64_t points = 0;  ///< number of points in these nodes
    bool whole = true;         ///< no useful node was dropped to meet the budget
};

/// Maximum number of nodes in a plan.
inline constexpr std::size_t max_point_nodes = 4096;

/// Whether nodes are tested against the frustum: `none` is only for comparison.
enum class PointCulling {
    hierarchical,  ///< all nodes; descendants of a node that is outside are skipped
    none
};

/// Plans at most `budget` points, but always the root if it is in view. Skips nodes that are outside the
/// frustum, but never a node with a point inside. Also skips descendants of nodes whose point spacing is less
/// than a sample, with `side` samples per side of a pixel. Nodes that are not tested count as in view.
PointPlan plan_points(const PointCloud& cloud, const View& view, std::uint64_t budget, int side,
                      PointCulling culling = PointCulling::hierarchical);

/// A drawn node, and which of its children are drawn.
struct DrawnNode {
    std::uint32_t node;
    std::uint32_t children;  ///< bit i: the child in octant i
    std::uint32_t first;  ///< index of its first drawn child among all drawn nodes; its other children follow
};

/// The nodes to draw if only some planned nodes are `resident`: those with all ancestors resident, root
/// first.
std::vector<DrawnNode> drawn_nodes(const PointCloud& cloud, const PointPlan& plan,
                                   const std::function<bool(std::uint32_t node)>& resident);

/// The range of distances along the view's axis, as depth_range() returns it for clusters. Returns 0 to 0 if
/// all nodes are behind the viewer.
Eigen::Vector2d depth_range(const PointCloud& cloud, const PointPlan& plan, const View& view, double reach);

}  // namespace vantage
