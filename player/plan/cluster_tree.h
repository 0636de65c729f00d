#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "player/view/view.h"
#include "scene/package/package_format.h"

namespace vantage {

/// The center of a cluster, relative to the origin of the scene.
Eigen::Vector3d center(const package::ClusterRecord& cluster);

/// A tree of boxes over runs of consecutive clusters. Runs are halved until they have at most 8 clusters;
/// parents precede their children.
struct ClusterTree {
    struct Node {
        Eigen::Vector3d low, high;
        std::uint32_t first, count;  ///< clusters
        std::uint32_t next;          ///< the node after all of this one's descendants
    };
    std::vector<Node> nodes;
};
ClusterTree make_cluster_tree(std::span<const package::ClusterRecord> clusters);

/// The clusters whose bounding spheres intersect the view frustum, in ascending order. May include clusters
/// just outside the frustum.
std::vector<std::uint32_t> clusters_in_view(const ClusterTree& tree,
                                            std::span<const package::ClusterRecord> clusters,
                                            const View& view);
/// Finds the same clusters, and replaces the content of `found` with them.
void find_clusters_in_view(const ClusterTree& tree, std::span<const package::ClusterRecord> clusters,
                           const View& view, std::vector<std::uint32_t>& found);

/// Whether all triangles of the cluster face away from `eye`, according to its normal cone.
bool faces_away(const package::ClusterRecord& cluster, const Eigen::Vector3d& eye);

/// Near and far planes that enclose the clusters' bounding spheres. `reach`: as for clip_range, but not used
/// for orthographic views.
Eigen::Vector2d depth_range(std::span<const package::ClusterRecord> clusters,
                            std::span<const std::uint32_t> in_view, const View& view,
                            double reach = std::numeric_limits<double>::infinity());

}  // namespace vantage
