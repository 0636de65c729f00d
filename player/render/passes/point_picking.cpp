#include "player/render/passes/point_picking.h"

#include <cstring>

#include "shaders/contract.h"

namespace vantage {

static_assert(shader::points_per_node == package::point_node &&
              std::uint64_t(max_point_nodes) * package::point_node < 0xffffffffu);

std::optional<PickedPoint> point_numbered(const PackageReader& package, const PointCloud& cloud,
                                          std::span<const DrawnNode> nodes, std::uint32_t number) {
    if (number == 0) return {};
    const std::uint32_t node = (number - 1) / shader::points_per_node,
                        place = (number - 1) % shader::points_per_node;
    if (node >= nodes.size()) return {};
    const package::PointNode& n = cloud.nodes[nodes[node].node];
    const package::DirectoryEntry* chunk = package.find(package::Type::points);
    if (place >= n.count || !chunk || n.block >= package.blocks(*chunk)) return {};
    package::PackedPoint p;
    const PackageReader::Part head = package.head(*chunk), block = package.block(*chunk, n.block);
    const Held held = package.hold(std::array{head, block});
    std::memcpy(&p, block.data() + (n.first + place) * sizeof p, sizeof p);
    const Eigen::Vector3d origin = Eigen::Map<const Eigen::Vector3d>(package.scene().origin);
    return PickedPoint{origin + unpacked(p, n), {p.color[0], p.color[1], p.color[2]}};
}

void PointPicking::take(const PackageReader& package, const PointPass& points) {
    if (const auto number = number_.take(false))
        found_ = point_numbered(package, points.cloud(), nodes_, number->front());
}

void PointPicking::look(const PackageReader& package, const PointPass& points, const Eigen::Vector2i& pixel,
                        int width, int height) {
    take(package, points);
    if (number_.pending()) return;
    if (!points.placed() || pixel.minCoeff() < 0 || pixel.x() >= width || pixel.y() >= height) {
        found_.reset();
        return;
    }
    if (!number_ && !number_.allocate("picked point", 1)) return;
    glBindBuffer(GL_PIXEL_PACK_BUFFER, number_.id());
    glGetTextureSubImage(points.numbers(), 0, pixel.x(), pixel.y(), 0, 1, 1, 1, GL_RED_INTEGER,
                         GL_UNSIGNED_INT, sizeof(std::uint32_t), nullptr);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    number_.begin();
    nodes_ = points.drawn();
}

}  // namespace vantage
