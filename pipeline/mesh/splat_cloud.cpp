#include "pipeline/mesh/splat_cloud.h"

#include <cstring>

#include "base/text/error.h"
#include "scene/package/contents/point_cloud.h"

namespace vantage {
namespace {

using package::PackedPoint;
using package::PointNode;

class Collector {
  public:
    explicit Collector(const std::vector<PointNode>& nodes)
        : nodes_(nodes), spacings_(local_spacings(nodes)) {}

    void add(std::uint32_t node, const PackedPoint& p) {
        out_.positions.push_back(unpacked(p, nodes_[node]).cast<float>());
        out_.radii.push_back(spacings_[finest_node(nodes_, node, p)] / 2);
    }
    SplatCloud take() { return std::move(out_); }

  private:
    const std::vector<PointNode>& nodes_;
    std::vector<float> spacings_;
    SplatCloud out_;
};

}  // namespace

SplatCloud splat_cloud(const PointTree& tree, const Mesh& cloud, const Eigen::Vector3d& origin) {
    Collector all(tree.nodes);
    for (std::uint32_t n = 0; n < tree.nodes.size(); ++n)
        for (std::uint32_t i = 0; i < tree.nodes[n].count; ++i)
            all.add(n, packed(cloud.positions[tree.order[tree.starts[n] + i]] - origin, tree.nodes[n]));
    return all.take();
}

SplatCloud splat_cloud(const PackageReader& package) {
    const auto cloud = read_point_cloud(package);
    if (!cloud) throw Error(Exit::damaged, package.path().string() + ": PNOD is missing");
    const package::DirectoryEntry& chunk = *package.find(package::Type::points);
    Collector all(cloud->nodes);
    for (std::uint32_t n = 0; n < cloud->nodes.size(); ++n) {
        const PointNode& node = cloud->nodes[n];
        const auto block = package.valid_block(chunk, node.block);
        for (std::uint32_t i = 0; i < node.count; ++i) {
            PackedPoint p;
            std::memcpy(&p, block.data() + (node.first + i) * sizeof p, sizeof p);
            all.add(n, p);
        }
    }
    return all.take();
}

}  // namespace vantage
