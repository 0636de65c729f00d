#include "pipeline/align/start_poses.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/values/nearest_rotation.h"
#include "base/values/quantile.h"
#include "pipeline/run/for_each_photo.h"

namespace vantage {
namespace {

using Eigen::Vector3d;
using PointSet = std::vector<Vector3d>;

constexpr std::size_t rotations = 600, used_points = 200;
constexpr double scales[] = {0.5, 0.7, 1, 1.4, 2};  ///< scales to try, relative to the ratio of sizes
constexpr double overlap = 0.7;                     ///< assumed fraction of the points that are on the mesh
constexpr int cells = 48;                           ///< number of cells along the longest side of the grid
/// ICP iterations per round; each round continues with the best fifth of the poses.
constexpr int iterations[] = {8, 20, 40};

/// The i-th of n rotations spread evenly (super-Fibonacci spirals; Alexa 2022).
Eigen::Matrix3d spread_rotation(std::size_t i, std::size_t n) {
    constexpr double phi = std::numbers::sqrt2, psi = 1.533751168755204288118041;
    const double s = double(i) + 0.5, r = std::sqrt(s / double(n)), R = std::sqrt(1 - s / double(n));
    const double a = 2 * std::numbers::pi * s / phi, b = 2 * std::numbers::pi * s / psi;
    return Eigen::Quaterniond(R * std::cos(b), r * std::sin(a), r * std::cos(a), R * std::sin(b))
        .toRotationMatrix();
}

/// The center of points and their typical distance from it, robust to outliers.
struct Extent {
    Vector3d middle;
    double size;
};
Extent extent_of(const PointSet& points) {
    Extent out;
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double> values;
        for (const Vector3d& p : points) values.push_back(p[axis]);
        out.middle[axis] = quantile(std::move(values), 0.5);
    }
    std::vector<double> distances;
    for (const Vector3d& p : points) distances.push_back((p - out.middle).norm());
    out.size = quantile(std::move(distances), 0.5);
    return out;
}

/// Every n-th point, up to `count` points.
PointSet some_of(std::span<const Vector3d> all, std::size_t count) {
    PointSet out;
    for (std::size_t i = 0; i < std::min(count, all.size()); ++i)
        out.push_back(all[i * all.size() / std::min(count, all.size())]);
    return out;
}

/// Centers of triangles, sampled in proportion to their area.
PointSet on_surface(const Mesh& mesh, std::size_t count) {
    std::vector<double> until;
    double area = 0;
    for (const auto& t : mesh.triangles) {
        const Vector3d &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
        until.push_back(area += (b - a).cross(c - a).norm());
    }
    PointSet out;
    for (std::size_t i = 0; i < count && area > 0; ++i) {
        const auto at = std::ranges::lower_bound(until, area * (double(i) + 0.5) / double(count));
        const auto& t = mesh.triangles[std::size_t(std::min(at, until.end() - 1) - until.begin())];
        out.push_back((mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3);
    }
    return out;
}

/// For the center of each cell of a grid in and around the surface's box, the nearest point on the surface.
class NearestGrid {
  public:
    NearestGrid(const PointSet& mesh, const NearestSurface& surface) {
        Eigen::AlignedBox3d box;
        for (const Vector3d& p : mesh) box.extend(p);
        const Vector3d margin = Vector3d::Constant(0.25 * box.sizes().maxCoeff());
        low_ = box.min() - margin;
        const Vector3d sizes = box.sizes() + 2 * margin;
        cell_ = sizes.maxCoeff() / cells;
        count_ = (sizes / cell_).array().ceil().max(1).cast<int>();
        nearest_.resize(std::size_t(count_.prod()));
        for_each_photo(std::size_t(count_.z()), 0, [&](std::size_t z) {
            for (int y = 0; y < count_.y(); ++y)
                for (int x = 0; x < count_.x(); ++x) {
                    const Vector3d middle(x + 0.5, y + 0.5, double(z) + 0.5);
                    nearest_[index(x, y, int(z))] = surface.nearest(low_ + cell_ * middle).point;
                }
        });
    }
    const Vector3d& nearest(const Vector3d& at) const {
        const Eigen::Array3d cell = ((at - low_) / cell_).array().max(0).min(1e6);
        const Eigen::Array3i c = cell.cast<int>().min(count_ - 1);
        return nearest_[index(c.x(), c.y(), c.z())];
    }

  private:
    std::size_t index(int x, int y, int z) const {
        return std::size_t((z * count_.y() + y) * count_.x() + x);
    }
    Vector3d low_;
    double cell_;
    Eigen::Array3i count_;
    PointSet nearest_;
};

/// A starting pose and the mean distance of the points from the surface, in the units of the points.
struct Start {
    Similarity to_mesh;
    double distance = std::numeric_limits<double>::infinity();
};

/// The least-squares similarity from `p` to `q`, with Horn's symmetric scale (Horn 1987).
Similarity fit(const PointSet& p, const PointSet& q, std::span<const std::size_t> which) {
    Vector3d mp = Vector3d::Zero(), mq = Vector3d::Zero();
    for (const std::size_t i : which) mp += p[i] / double(which.size()), mq += q[i] / double(which.size());
    Eigen::Matrix3d both = Eigen::Matrix3d::Zero();
    double pp = 0, qq = 0;
    for (const std::size_t i : which) {
        both += (q[i] - mq) * (p[i] - mp).transpose();
        pp += (p[i] - mp).squaredNorm(), qq += (q[i] - mq).squaredNorm();
    }
    Similarity out;
    out.R = nearest_rotation(both);
    out.scale = std::sqrt(qq / pp);
    out.t = mq - out.scale * (out.R * mp);
    return out;
}

/// ICP on the fraction `overlap` of the points that are nearest to the surface.
void improve(Start& start, const PointSet& points, const NearestGrid& surface, int times) {
    const auto used = std::size_t(overlap * double(points.size()));
    PointSet nearest(points.size());
    std::vector<double> distance(points.size());
    std::vector<std::size_t> order(points.size());
    for (int n = 0; n <= times; ++n) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Vector3d at = start.to_mesh(points[i]);
            nearest[i] = surface.nearest(at), distance[i] = (at - nearest[i]).norm(), order[i] = i;
        }
        std::ranges::nth_element(order, order.begin() + std::ptrdiff_t(used), {},
                                 [&](std::size_t i) { return distance[i]; });
        double sum = 0;
        for (std::size_t i = 0; i < used; ++i) sum += distance[order[i]];
        // The distance is in the points' units, so that shrinking does not reduce it.
        start.distance = sum / double(used) / start.to_mesh.scale;
        if (n == times) return;
        start.to_mesh = fit(points, nearest, std::span(order).first(used));
        if (!(start.to_mesh.scale > 0) || !start.to_mesh.t.allFinite()) {
            start.distance = std::numeric_limits<double>::infinity();
            return;
        }
    }
}

std::vector<Start> all_starts(const PointSet& points, const PointSet& mesh) {
    const Extent from = extent_of(points), to = extent_of(mesh);
    std::vector<Start> out;
    if (!(from.size > 0) || !(to.size > 0)) return out;
    for (const double scale : scales)
        for (std::size_t i = 0; i < rotations; ++i) {
            Similarity s{spread_rotation(i, rotations), Vector3d::Zero(), scale * to.size / from.size};
            s.t = to.middle - s.scale * (s.R * from.middle);
            out.push_back({s});
        }
    return out;
}

}  // namespace

std::vector<Similarity> start_poses(std::span<const Vector3d> all, const Mesh& mesh,
                                    const NearestSurface& surface, std::size_t count) {
    const PointSet points = some_of(all, used_points);
    const PointSet on_mesh = on_surface(mesh, 2000);
    std::vector<Start> starts = all_starts(points, on_mesh);
    if (starts.empty()) return {};
    const NearestGrid grid(on_mesh, surface);
    for (const int times : iterations) {
        for_each_photo(starts.size(), 0, [&](std::size_t i) { improve(starts[i], points, grid, times); });
        std::ranges::stable_sort(starts, {}, &Start::distance);
        starts.resize(std::min(starts.size(), std::max(count, starts.size() / 5)));
    }
    std::vector<Similarity> out;
    for (const Start& s : starts)
        if (out.size() < count && std::isfinite(s.distance)) out.push_back(s.to_mesh);
    return out;
}

}  // namespace vantage
