#include "pipeline/mesh/stand_in.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "base/values/principal_axes.h"

namespace vantage {
namespace {

constexpr int finest = 10;  ///< maximum number of halvings of the cloud's cube

/// Moves bits 0 to 9 to every third position.
std::uint32_t spread(std::uint32_t v) {
    v = (v | v << 16) & 0x030000ff;
    v = (v | v << 8) & 0x0300f00f;
    v = (v | v << 4) & 0x030c30c3;
    return (v | v << 2) & 0x09249249;
}
std::uint32_t code_of(const Eigen::Vector3i& cell) {
    return spread(std::uint32_t(cell.x())) | spread(std::uint32_t(cell.y())) << 1 |
           spread(std::uint32_t(cell.z())) << 2;
}

/// The number of points, their sum, and the sum of their outer products, relative to the cube's corner.
struct Moments {
    double count = 0;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    Eigen::Matrix3d products = Eigen::Matrix3d::Zero();

    void add(const Eigen::Vector3d& p) {
        count += 1;
        sum += p;
        products += p * p.transpose();
    }
    void add(const Moments& m) {
        count += m.count;
        sum += m.sum;
        products += m.products;
    }
    Eigen::Vector3d mean() const { return sum / count; }
};

struct Cell {
    std::uint32_t code;  ///< code of its position; see code_of()
    Eigen::Vector3i place;
    Moments points;
};

/// The cube around a cloud and its grid.
struct CellGrid {
    Eigen::Vector3d low;
    double size;  ///< of a cell
    int level;    ///< halvings

    Eigen::Vector3i place(const Eigen::Vector3d& p) const {
        const double most = double((1 << level) - 1);
        Eigen::Vector3i out;
        for (int axis = 0; axis < 3; ++axis)
            out[axis] = int(std::clamp(std::floor((p[axis] - low[axis]) / size), 0.0, most));
        return out;
    }
};

/// The grid of the cube around the cloud, whose size is never zero, even for a single point far from the
/// origin.
CellGrid cube_around(const Mesh& cloud) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& p : cloud.positions) box.extend(p);
    const double reach = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
    const double size = std::max({box.sizes().maxCoeff(), reach * 1e-6, 1e-12});
    return {box.center() - Eigen::Vector3d::Constant(size / 2), size, 0};
}

CellGrid grid_of(const Mesh& cloud) {
    CellGrid grid = cube_around(cloud);
    grid.level = finest;
    grid.size /= 1 << finest;
    std::vector<std::uint32_t> codes;
    codes.reserve(cloud.positions.size());
    for (const Eigen::Vector3d& p : cloud.positions) codes.push_back(code_of(grid.place(p)));
    std::ranges::sort(codes);
    codes.erase(std::unique(codes.begin(), codes.end()), codes.end());
    while (codes.size() > max_facets) {
        --grid.level;
        grid.size *= 2;
        for (std::uint32_t& c : codes) c >>= 3;
        codes.erase(std::unique(codes.begin(), codes.end()), codes.end());
    }
    return grid;
}

/// Sorted by code.
std::vector<Cell> cells_of(const Mesh& cloud, const CellGrid& grid) {
    std::vector<std::uint32_t> codes;
    codes.reserve(cloud.positions.size());
    for (const Eigen::Vector3d& p : cloud.positions) codes.push_back(code_of(grid.place(p)));
    std::vector<std::uint32_t> known = codes;
    std::ranges::sort(known);
    known.erase(std::unique(known.begin(), known.end()), known.end());
    std::vector<Cell> cells(known.size());
    for (std::size_t i = 0; i < codes.size(); ++i) {
        Cell& c = cells[std::size_t(std::ranges::lower_bound(known, codes[i]) - known.begin())];
        c.code = codes[i];
        c.place = grid.place(cloud.positions[i]);
        c.points.add(cloud.positions[i] - grid.low);
    }
    return cells;
}

/// The normal of the best-fitting plane of the points in a cell and its neighbors. If these points do not
/// span a plane, it is any direction perpendicular to them.
Eigen::Vector3d normal_of(const std::vector<Cell>& cells, const Cell& at, const CellGrid& grid) {
    Moments around;
    const int most = (1 << grid.level) - 1;
    for (int i = 0; i < 27; ++i) {
        const Eigen::Vector3i place = at.place + Eigen::Vector3i(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
        if (place.minCoeff() < 0 || place.maxCoeff() > most) continue;
        const std::uint32_t code = code_of(place);
        const auto found = std::ranges::lower_bound(cells, code, {}, &Cell::code);
        if (found != cells.end() && found->code == code) around.add(found->points);
    }
    const Eigen::Vector3d mean = around.mean() / grid.size;
    const Eigen::Matrix3d covariance =
        around.products / (around.count * grid.size * grid.size) - mean * mean.transpose();
    const Eigen::Vector3d n = principal_axes(covariance).axes.col(0);
    return n.allFinite() && n.norm() > 0.5 ? n.normalized() : Eigen::Vector3d::UnitZ().eval();
}

/// The direction from which the surface is seen.
Eigen::Vector3d outward(const Eigen::Vector3d& p, const Eigen::Vector3d& middle,
                        std::span<const Eigen::Vector3d> eyes) {
    if (eyes.empty()) return p - middle;
    const Eigen::Vector3d* nearest = &eyes.front();
    for (const Eigen::Vector3d& eye : eyes)
        if ((eye - p).squaredNorm() < (*nearest - p).squaredNorm()) nearest = &eye;
    return *nearest - p;
}

/// Adds an equilateral triangle that contains the cell's circle.
void add_facet(const Eigen::Vector3d& center, const Eigen::Vector3d& normal, double cell, Mesh& out) {
    const Eigen::Vector3d x = normal.unitOrthogonal(), y = normal.cross(x);
    const auto first = std::uint32_t(out.positions.size());
    for (const Eigen::Vector2d& corner : {Eigen::Vector2d(1, 0), Eigen::Vector2d(-0.5, std::sqrt(0.75)),
                                          Eigen::Vector2d(-0.5, -std::sqrt(0.75))}) {
        out.positions.emplace_back(center + cell * (corner.x() * x + corner.y() * y));
        out.normals.push_back(normal.cast<float>());
    }
    out.triangles.push_back({first, first + 1, first + 2});
}

}  // namespace

Mesh stand_in(const Mesh& cloud, std::span<const Eigen::Vector3d> eyes) {
    const CellGrid grid = grid_of(cloud);
    const std::vector<Cell> cells = cells_of(cloud, grid);
    const Eigen::Vector3d middle = grid.low + Eigen::Vector3d::Constant(grid.size * (1 << grid.level) / 2);
    Mesh out;
    for (const Cell& c : cells) {
        const Eigen::Vector3d center = grid.low + c.points.mean();
        const Eigen::Vector3d n = normal_of(cells, c, grid);
        add_facet(center, n.dot(outward(center, middle, eyes)) < 0 ? (-n).eval() : n, grid.size, out);
    }
    return out;
}

double facet_size(std::span<const Eigen::Vector3f> positions, std::span<const std::uint32_t> indices) {
    if (indices.size() < 3) return 0;
    return double((positions[indices[1]] - positions[indices[0]]).norm());
}

}  // namespace vantage
