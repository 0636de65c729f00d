#include "player/plan/cluster_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "player/plan/frustum.h"

namespace vantage {
Eigen::Vector3d center(const package::ClusterRecord& c) { return {c.center[0], c.center[1], c.center[2]}; }

namespace {

constexpr std::uint32_t leaf_clusters = 8;

std::uint32_t add_node(ClusterTree& tree, std::span<const package::ClusterRecord> clusters,
                       std::uint32_t first, std::uint32_t count) {
    const auto at = std::uint32_t(tree.nodes.size());
    tree.nodes.push_back({Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity()),
                          Eigen::Vector3d::Constant(-std::numeric_limits<double>::infinity()), first, count,
                          0});
    ClusterTree::Node node = tree.nodes[at];
    if (count <= leaf_clusters) {
        for (const package::ClusterRecord& c : clusters.subspan(first, count)) {
            node.low = node.low.cwiseMin((center(c).array() - c.radius).matrix());
            node.high = node.high.cwiseMax((center(c).array() + c.radius).matrix());
        }
    } else {
        for (const std::uint32_t child : {add_node(tree, clusters, first, count / 2),
                                          add_node(tree, clusters, first + count / 2, count - count / 2)}) {
            node.low = node.low.cwiseMin(tree.nodes[child].low);
            node.high = node.high.cwiseMax(tree.nodes[child].high);
        }
    }
    node.next = std::uint32_t(tree.nodes.size());
    tree.nodes[at] = node;
    return at;
}

}  // namespace

ClusterTree make_cluster_tree(std::span<const package::ClusterRecord> clusters) {
    ClusterTree tree;
    if (!clusters.empty()) add_node(tree, clusters, 0, std::uint32_t(clusters.size()));
    return tree;
}

std::vector<std::uint32_t> clusters_in_view(const ClusterTree& tree,
                                            std::span<const package::ClusterRecord> clusters,
                                            const View& view) {
    std::vector<std::uint32_t> out;
    find_clusters_in_view(tree, clusters, view, out);
    return out;
}

void find_clusters_in_view(const ClusterTree& tree, std::span<const package::ClusterRecord> clusters,
                           const View& view, std::vector<std::uint32_t>& out) {
    const Frustum planes = frustum(view);
    out.clear();
    for (std::size_t i = 0; i < tree.nodes.size();) {
        const ClusterTree::Node& node = tree.nodes[i];
        const Side side = side_of(planes, node.low, node.high);
        const bool leaf = node.next == i + 1;
        if (side == Side::inside || (side == Side::across && leaf))
            for (std::uint32_t c = node.first; c < node.first + node.count; ++c)
                if (side == Side::inside || reaches(planes, center(clusters[c]), clusters[c].radius))
                    out.push_back(c);
        i = side == Side::across ? i + 1 : node.next;
    }
}

bool faces_away(const package::ClusterRecord& c, const Eigen::Vector3d& eye) {
    const Eigen::Vector3d to = center(c) - eye, axis(c.cone_axis[0], c.cone_axis[1], c.cone_axis[2]);
    return c.cone_cutoff < 1 && to.dot(axis) >= c.cone_cutoff * to.norm() + c.radius;
}

Eigen::Vector2d depth_range(std::span<const package::ClusterRecord> clusters,
                            std::span<const std::uint32_t> in_view, const View& view, double reach) {
    double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
    for (const std::uint32_t i : in_view) {
        const package::ClusterRecord& c = clusters[i];
        const double z = (view.cam_from_origin.R * center(c) + view.cam_from_origin.t).z();
        if (z + c.radius <= 0) continue;
        nearest = std::min(nearest, z - c.radius);
        farthest = std::max(farthest, z + c.radius);
    }
    if (view.orthographic_depth > 0 && farthest > 0) {
        const double margin = 1e-3 * (farthest - nearest) + 1e-12 * farthest;
        return {nearest - margin, farthest + margin};
    }
    return clip_range(nearest, farthest, reach);
}

}  // namespace vantage
