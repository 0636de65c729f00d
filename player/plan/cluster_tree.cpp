#include "player/plan/cluster_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace vantage {
namespace {

constexpr std::uint32_t leaf_clusters = 8;
constexpr double rounding = 1e-12;  // error of a distance from a plane, relative to its terms

Eigen::Vector3d center(const package::ClusterRecord& c) { return {c.center[0], c.center[1], c.center[2]}; }

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

/// Inside: normal.dot(p) + offset >= 0, relative to the origin.
struct Plane {
    Eigen::Vector3d normal;
    double offset;
};

std::array<Plane, 5> frustum(const View& view) {
    const Intrinsics& k = view.intrinsics;
    const Pose& pose = view.cam_from_origin;
    const std::array<Eigen::Vector3d, 5> in_camera{
        Eigen::Vector3d(k.fx, 0, k.cx).normalized(), Eigen::Vector3d(-k.fx, 0, k.width - k.cx).normalized(),
        Eigen::Vector3d(0, k.fy, k.cy).normalized(), Eigen::Vector3d(0, -k.fy, k.height - k.cy).normalized(),
        Eigen::Vector3d::UnitZ()};
    std::array<Plane, 5> planes;
    for (std::size_t i = 0; i < 5; ++i)
        planes[i] = {pose.R.transpose() * in_camera[i], in_camera[i].dot(pose.t)};
    return planes;
}

enum class Side { outside, across, inside };

Side side_of(const ClusterTree::Node& node, const std::array<Plane, 5>& planes) {
    const Eigen::Vector3d middle = (node.low + node.high) / 2, half = (node.high - node.low) / 2;
    Side side = Side::inside;
    for (const Plane& p : planes) {
        const double distance = p.normal.dot(middle) + p.offset,
                     reach = p.normal.cwiseAbs().dot(half) * (1 + 1e-5) +
                             rounding * (middle.norm() + std::abs(p.offset));
        if (distance < -reach) return Side::outside;
        if (distance < reach) side = Side::across;
    }
    return side;
}

bool reaches_in(const package::ClusterRecord& c, const std::array<Plane, 5>& planes) {
    const Eigen::Vector3d p = center(c);
    return std::all_of(planes.begin(), planes.end(), [&](const Plane& plane) {
        const double reach = c.radius * (1 + 1e-5) + rounding * (p.norm() + std::abs(plane.offset));
        return plane.normal.dot(p) + plane.offset >= -reach;
    });
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
    const std::array<Plane, 5> planes = frustum(view);
    std::vector<std::uint32_t> out;
    for (std::size_t i = 0; i < tree.nodes.size();) {
        const ClusterTree::Node& node = tree.nodes[i];
        const Side side = side_of(node, planes);
        const bool leaf = node.next == i + 1;
        if (side == Side::inside || (side == Side::across && leaf))
            for (std::uint32_t c = node.first; c < node.first + node.count; ++c)
                if (side == Side::inside || reaches_in(clusters[c], planes)) out.push_back(c);
        i = side == Side::across ? i + 1 : node.next;
    }
    return out;
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
    return clip_range(nearest, farthest, reach);
}

}  // namespace vantage
