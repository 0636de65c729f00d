#include "scene/package/contents/point_cloud.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/text/error.h"

namespace vantage {
namespace {

using package::PointNode;

constexpr int bits = 21;
constexpr std::uint64_t mask = (std::uint64_t(1) << bits) - 1;

/// The first error in the nodes; empty if they are valid.
const char* problem(const PointCloud& cloud) {
    std::uint64_t next = 1;
    for (const PointNode& n : cloud.nodes) {
        const float sum = n.low[0] + n.low[1] + n.low[2] + n.size + n.spacing;
        if (!std::isfinite(sum) || !(n.size > 0) || !(n.spacing > 0)) return "a node's cube is out of range";
        if (n.count > package::point_node || n.block >= cloud.blocks ||
            n.first > package::point_block - n.count)
            return "a node's points are out of range";
        if (n.child_octants && n.children != next) return "a node's children are out of order";
        next += std::uint64_t(std::popcount(n.child_octants));
    }
    return next == cloud.nodes.size() ? "" : "nodes are missing";
}

}  // namespace

std::optional<PointCloud> read_point_cloud(const PackageReader& package) {
    if (!effect_on(package.scene(), Effect::points)) return std::nullopt;
    const auto fail = [&](const char* why) {
        return Error(Exit::damaged, package.path().string() + ": PNOD: " + why);
    };
    const auto nodes = package.records<PointNode>(package::Type::point_nodes);
    const package::DirectoryEntry* points = package.find(package::Type::points);
    constexpr std::size_t most = std::size_t(1) << 26;
    if (nodes.empty() || nodes.size() > most) throw fail("has no nodes, or too many of them");
    if (!points || points->block_length != package::point_block * sizeof(package::PackedPoint))
        throw fail("PNTS is missing, or the length of its blocks is wrong");
    PointCloud cloud;
    cloud.nodes.assign(nodes.begin(), nodes.end());
    cloud.blocks = std::uint32_t(std::min<std::size_t>(package.blocks(*points), 0xffffffffu));
    if (const char* why = problem(cloud); *why) throw fail(why);
    for (const PointNode& n : cloud.nodes) cloud.points += n.count;
    return cloud;
}

package::PackedPoint packed(const Eigen::Vector3d& position, const PointNode& node) {
    std::uint64_t all = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double share = (position[axis] - double(node.low[axis])) / double(node.size);
        const double cell = std::floor(std::clamp(share, 0.0, 1.0) * double(mask + 1));
        all |= std::min(std::uint64_t(cell), mask) << (bits * axis);
    }
    return {std::uint32_t(all), std::uint32_t(all >> 32), {0, 0, 0, 255}};
}

Eigen::Vector3d unpacked(const package::PackedPoint& point, const PointNode& node) {
    const std::uint64_t all = std::uint64_t(point.high) << 32 | point.low;
    Eigen::Vector3d out;
    for (int axis = 0; axis < 3; ++axis)
        out[axis] = double(node.low[axis]) +
                    (double(all >> (bits * axis) & mask) + 0.5) / double(mask + 1) * double(node.size);
    return out;
}

std::vector<float> local_spacings(const std::vector<PointNode>& nodes) {
    std::vector<float> out;
    for (const PointNode& n : nodes) out.push_back(n.spacing);
    for (std::size_t i = 0; i < nodes.size(); ++i)
        for (std::size_t c = 0; c < std::size_t(std::popcount(nodes[i].child_octants)); ++c) {
            float& child = out[nodes[i].children + c];
            child = std::min(child, out[i]);
        }
    return out;
}

std::uint32_t finest_node(const std::vector<PointNode>& nodes, std::uint32_t node,
                          const package::PackedPoint& point) {
    const std::uint64_t all = std::uint64_t(point.high) << 32 | point.low;
    for (int bit = bits - 1; bit >= 0; --bit) {
        unsigned octant = 0;
        for (int axis = 0; axis < 3; ++axis) octant |= unsigned(all >> (bits * axis + bit) & 1) << axis;
        const unsigned children = nodes[node].child_octants;
        if (!(children >> octant & 1)) break;
        const std::uint32_t child =
            nodes[node].children + std::uint32_t(std::popcount(children & ((1u << octant) - 1)));
        if (nodes[child].size >= nodes[node].size) break;  // more points at the same place
        node = child;
    }
    return node;
}

}  // namespace vantage
