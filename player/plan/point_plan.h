#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <vector>

#include "player/view/view.h"
#include "scene/package/contents/point_cloud.h"

namespace vantage {

/// The nodes of a cloud that a view needs, each after its parent, the most urgent first: those whose points
/// are farthest apart in the picture, that is, the nearest and coarsest.
struct PointPlan {
    std::vector<std::uint32_t> nodes;
    std::uint64_t points = 0;  ///< of these nodes
    bool whole = true;         ///< no node that the view could use exceeded the budget
};

/// Maximum number of nodes in a plan.
inline constexpr std::size_t max_point_nodes = 4096;

/// Whether nodes are tested against the frustum: `none` only for comparison.
enum class PointCulling {
    hierarchical,  ///< all, and what is below a node that is outside is not visited
    none
};

/// At most `budget` points, but always the root if it is in view. Nodes outside the frustum are skipped,
/// never one with a point inside; and those below nodes whose points are less than a sample apart, with
/// `side` samples along a pixel. Nodes that are not tested count as in view.
PointPlan plan_points(const PointCloud& cloud, const View& view, std::uint64_t budget, int side,
                      PointCulling culling = PointCulling::hierarchical);

/// A node that is drawn, and which of its children are, too.
struct DrawnNode {
    std::uint32_t node;
    std::uint32_t children;  ///< bit i: the child that is the eighth i
    std::uint32_t first;     ///< number of its first drawn child among all drawn nodes; the others follow
};

/// What is drawn if only some of the planned nodes are `resident`: nodes whose ancestors are, too. The root
/// comes first.
std::vector<DrawnNode> drawn_nodes(const PointCloud& cloud, const PointPlan& plan,
                                   const std::function<bool(std::uint32_t node)>& resident);

/// Distances along the view's axis, 0 to 0 if all nodes are behind it: as depth_range().
Eigen::Vector2d depth_range(const PointCloud& cloud, const PointPlan& plan, const View& view, double reach);

}  // namespace vantage
