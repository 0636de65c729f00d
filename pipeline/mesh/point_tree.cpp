#include "pipeline/mesh/point_tree.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <deque>
#include <span>

#include "base/values/bytes_of.h"
#include "scene/package/contents/point_cloud.h"

namespace vantage {
namespace {

using package::PointNode;

constexpr int levels = 21;      ///< maximum number of halvings of the root's cube
constexpr int finest_grid = 6;  ///< maximum halvings of a node's cube into the cells of its grid
constexpr int finest_leaf = 8;  ///< maximum halvings of a leaf's cube to find the spacing of its points
constexpr std::array<std::uint8_t, 4> gray{200, 200, 200, 255};

/// A point and the Morton code of the cells that contain it: three bits per halving of the root's cube, of
/// which x is the lowest. The first halving is in the highest bits of the code.
struct Placed {
    std::uint64_t code;
    std::uint32_t point;
};
using Run = std::span<Placed>;

/// Moves bits 0 to 20 to every third position.
std::uint64_t spread(std::uint64_t v) {
    std::uint64_t out = 0;
    for (int bit = 0; bit < levels; ++bit) out |= (v >> bit & 1) << (3 * bit);
    return out;
}

std::uint64_t gathered(std::uint64_t code) {
    code &= 0x1249249249249249;
    code = (code | code >> 2) & 0x10c30c30c30c30c3;
    code = (code | code >> 4) & 0x100f00f00f00f00f;
    code = (code | code >> 8) & 0x1f0000ff0000ff;
    code = (code | code >> 16) & 0x1f00000000ffff;
    return (code | code >> 32) & 0x1fffff;
}

/// The cell that contains the point, at a level below the root's cube (0).
std::uint64_t cell(const Placed& p, int level) { return p.code >> (3 * (levels - level)); }
std::uint32_t octant(const Placed& p, int level) { return std::uint32_t(cell(p, level + 1) & 7); }

/// Squared distance of the point from the center of its cell at `level`, in units of the cell's side.
double from_middle(const Placed& p, int level) {
    const int below = levels - level;
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const std::uint64_t at = gathered(p.code >> axis) & ((std::uint64_t(1) << below) - 1);
        const double off = (double(at) + 0.5) / double(std::uint64_t(1) << below) - 0.5;
        sum += off * off;
    }
    return sum;
}

std::size_t cells_in(Run points, int level) {
    std::size_t count = points.empty() ? 0 : 1;
    for (std::size_t i = 1; i < points.size(); ++i)
        count += cell(points[i], level) != cell(points[i - 1], level);
    return count;
}

class Builder {
  public:
    Builder(const Mesh& cloud, const Eigen::Vector3d& origin) { place(cloud, origin); }

    PointTree build() {
        if (placed_.empty()) return {};
        todo_.push_back({placed_, 0});
        std::uint32_t numbered = 1;
        for (; !todo_.empty(); todo_.pop_front()) {
            add(todo_.front(), numbered);
            numbered += std::uint32_t(std::popcount(tree_.nodes.back().child_octants));
        }
        for (const Placed& p : placed_) tree_.order.push_back(p.point);
        fill_blocks();
        return std::move(tree_);
    }

  private:
    /// Points of a node and its descendants, in Morton order.
    struct Todo {
        Run points;
        int level;
    };

    /// Places all points in a slightly enlarged cube, so that rounding to single precision leaves none
    /// outside.
    void place(const Mesh& cloud, const Eigen::Vector3d& origin) {
        Eigen::AlignedBox3d box;
        for (const Eigen::Vector3d& p : cloud.positions) box.extend(p - origin);
        if (box.isEmpty()) return;
        const double reach = box.center().cwiseAbs().maxCoeff();
        size_ = std::max(box.sizes().maxCoeff(), 1e-30) * (1 + 1e-6) + reach * 1e-6;
        low_ = box.center() - Eigen::Vector3d::Constant(size_ / 2);
        constexpr double cells = 1 << levels;
        placed_.reserve(cloud.positions.size());
        for (std::uint32_t i = 0; i < cloud.positions.size(); ++i) {
            const Eigen::Vector3d at = (cloud.positions[i] - origin - low_) / size_ * cells;
            std::uint64_t code = 0;
            for (int axis = 0; axis < 3; ++axis)
                code |= spread(std::uint64_t(std::clamp(at[axis], 0.0, cells - 1))) << axis;
            placed_.push_back({code, i});
        }
        std::ranges::sort(placed_, {}, [](const Placed& p) { return std::pair(p.code, p.point); });
    }

    PointNode cube_of(const Todo& todo) const {
        PointNode node{};
        const double share = 1 / double(std::uint64_t(1) << todo.level);
        const std::uint64_t at = cell(todo.points.front(), todo.level);
        node.size = float(size_ * share);
        for (int axis = 0; axis < 3; ++axis)
            node.low[axis] = float(low_[axis] + double(gathered(at >> axis)) * size_ * share);
        return node;
    }

    void add(const Todo& todo, std::uint32_t children) {
        PointNode node = cube_of(todo);
        node.children = children;
        std::size_t taken = todo.points.size();
        const bool deepest = todo.level == levels;
        if (taken <= package::point_node) {
            node.spacing = spacing_of(todo, node.size);
        } else if (deepest) {  // all at one position: a chain of nodes
            taken = package::point_node;
            node.spacing = node.size;
        } else {
            const int grid = grid_of(todo);
            taken = take_sample(todo.points, todo.level + grid);
            node.spacing = std::ldexp(node.size, -grid);
        }
        node.count = std::uint32_t(taken);
        hand_on(todo.points.subspan(taken), todo.level, node);
        tree_.starts.push_back(std::uint64_t(todo.points.data() - placed_.data()));
        tree_.nodes.push_back(node);
    }

    /// The finest grid that has no more occupied cells than a node can have points.
    static int grid_of(const Todo& todo) {
        int grid = std::min(finest_grid, levels - todo.level);
        while (grid > 1 && cells_in(todo.points, todo.level + grid) > package::point_node) --grid;
        return grid;
    }

    /// The spacing of the finest grid whose occupied cells contain at least two of a leaf's points on
    /// average.
    static float spacing_of(const Todo& todo, float size) {
        int grid = std::min(finest_leaf, levels - todo.level);
        while (grid > 0 && double(todo.points.size()) < 2 * double(cells_in(todo.points, todo.level + grid)))
            --grid;
        return std::ldexp(size, -grid);
    }

    /// Moves one point per cell, the nearest to the cell's center, to the front, in order, and returns the
    /// number of these points.
    std::size_t take_sample(Run points, int level) {
        taken_.clear(), left_.clear();
        for (std::size_t begin = 0; begin < points.size();) {
            std::size_t best = begin, end = begin;
            double least = from_middle(points[begin], level);
            while (++end < points.size() && cell(points[end], level) == cell(points[begin], level))
                if (const double d = from_middle(points[end], level); d < least) least = d, best = end;
            for (std::size_t i = begin; i < end; ++i) (i == best ? taken_ : left_).push_back(points[i]);
            begin = end;
        }
        std::ranges::copy(left_, std::ranges::copy(taken_, points.begin()).out);
        return taken_.size();
    }

    void hand_on(Run rest, int level, PointNode& node) {
        if (level == levels && !rest.empty()) {
            node.child_octants = 1;
            todo_.push_back({rest, level});
            return;
        }
        for (std::size_t begin = 0, end = 0; begin < rest.size(); begin = end) {
            while (end < rest.size() && octant(rest[end], level) == octant(rest[begin], level)) ++end;
            node.child_octants |= std::uint8_t(1u << octant(rest[begin], level));
            todo_.push_back({rest.subspan(begin, end - begin), level + 1});
        }
    }

    /// Fills blocks node by node; no node crosses a block boundary.
    void fill_blocks() {
        std::uint32_t block = 0, used = 0;
        for (PointNode& node : tree_.nodes) {
            if (used + node.count > package::point_block) ++block, used = 0;
            node.block = block, node.first = used;
            used += node.count;
        }
        tree_.blocks = block + 1;
    }

    Eigen::Vector3d low_ = Eigen::Vector3d::Zero();  ///< lowest corner of the root's cube
    double size_ = 1;
    std::vector<Placed> placed_, taken_, left_;
    std::deque<Todo> todo_;
    PointTree tree_;
};

}  // namespace

PointTree make_point_tree(const Mesh& cloud, const Eigen::Vector3d& origin) {
    return Builder(cloud, origin).build();
}

void write_points(PackageWriter& writer, const PointTree& tree, const Mesh& cloud,
                  const Eigen::Vector3d& origin) {
    writer.write(package::Type::point_nodes, package::scene_wide, bytes_of(tree.nodes));
    std::size_t next = 0;
    const auto fill = [&](std::size_t block, std::span<std::byte> bytes) {
        std::ranges::fill(bytes, std::byte(0));
        for (; next < tree.nodes.size() && tree.nodes[next].block == block; ++next) {
            const PointNode& node = tree.nodes[next];
            for (std::uint32_t i = 0; i < node.count; ++i) {
                const std::uint32_t point = tree.order[tree.starts[next] + i];
                package::PackedPoint p = packed(cloud.positions[point] - origin, node);
                std::copy_n((cloud.colors.empty() ? gray : cloud.colors[point]).begin(), 3, p.color);
                std::memcpy(bytes.data() + (node.first + i) * sizeof p, &p, sizeof p);
            }
        }
    };
    writer.write_blocks(package::Type::points, package::scene_wide, 0, fill);
}

}  // namespace vantage
