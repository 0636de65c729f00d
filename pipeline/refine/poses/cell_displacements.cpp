#include "pipeline/refine/poses/cell_displacements.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

#include "base/values/quantile.h"
#include "base/values/tiling.h"
#include "pipeline/refine/coarse_photo.h"
#include "pipeline/stages/tile_levels.h"

namespace vantage {
namespace {

using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using package::PairRecord;

constexpr int depth_side = 400;    ///< longer side of the depth level, texels
constexpr int reach = 3;           ///< texels around a cell's center that must be on one surface
constexpr double max_stretch = 5;  ///< maximum stretch from the second photo's pixels to the first's
constexpr double max_weight = 4;   ///< matches
constexpr int columns = package::pair_columns, rows = package::pair_rows;

struct GivenCamera {
    Intrinsics k;
    Pose pose;
    double distance;  ///< median depth of the visible surface

    explicit GivenCamera(const package::PhotoRecord& p)
        : k(intrinsics(p)), pose(cam_from_origin(p)), distance(p.seen_distance > 0 ? p.seen_distance : 1) {}
    double focal() const { return std::sqrt(k.fx * k.fy); }
    /// Derivatives of the pixel position with respect to a point, the pose and the lens.
    Eigen::Matrix<double, 2, 3> of_point(const Vector3d& x) const {
        return pixel_derivative(k, pose.R * x + pose.t) * pose.R;
    }
    Eigen::Matrix<double, 2, 6> of_pose(const Vector3d& x) const {
        const Vector3d p = pose.R * x + pose.t;
        Eigen::Matrix<double, 3, 6> d;
        for (int i = 0; i < 3; ++i) d.col(i) = Vector3d::Unit(i).cross(p) / focal();
        d.rightCols<3>() = Matrix3d::Identity() * (distance / focal());
        return pixel_derivative(k, p) * d;
    }
    Eigen::Matrix<double, 2, 3> of_lens(const Vector2d& pixel) const {
        const double row = pixel.y() / k.height - 0.5, corner = std::hypot(k.width, k.height) / 2;
        Eigen::Matrix<double, 2, 3> d;
        d << (pixel.x() - k.cx) / corner, row, 0, (pixel.y() - k.cy) / corner, 0, row;
        return d;
    }
};

/// A point on the surface and two tangents.
struct Place {
    Vector3d x;
    Eigen::Matrix<double, 3, 2> tangents;
};

/// The surface visible in a photo, at low resolution.
class Surface {
  public:
    Surface(const PoseRefinementInput& in, std::uint32_t photo) : pose_(cam_from_origin(in.photos[photo])) {
        const package::PhotoRecord& r = in.photos[photo];
        const int level = coarse_level(r, depth_side);
        const Level size = level_size(int(r.width), int(r.height), level);
        k_ = intrinsics(r).at_level(level);
        width_ = size.width, height_ = size.height;
        const auto bytes = read_level(in.package, r, photo, package::Type::depth, level);
        z_.resize(bytes.size() / sizeof(float));
        std::memcpy(z_.data(), bytes.data(), bytes.size());
    }
    /// The surface point at the position (u, v), in fractions of the photo's width and height; empty if its
    /// neighborhood is not one smooth surface.
    std::optional<Place> at(double u, double v) const {
        const int x = int(u * k_.width), y = int(v * k_.height);
        if (x < reach || y < reach || x + reach >= width_ || y + reach >= height_) return {};
        const double z = depth(x, y);
        for (int j = -reach; j <= reach; j += reach)
            for (int i = -reach; i <= reach; i += reach)
                if (!std::isfinite(z) || !(std::abs(depth(x + i, y + j) - z) <= depth_step * z)) return {};
        Place out{point(x, y), {}};
        out.tangents << point(x + 2, y) - point(x - 2, y), point(x, y + 2) - point(x, y - 2);
        return out;
    }

  private:
    double depth(int x, int y) const {
        return double(z_[std::size_t(y) * std::size_t(width_) + std::size_t(x)]);
    }
    Vector3d point(int x, int y) const {
        const Vector3d ray((x + 0.5 - k_.cx) / k_.fx, (y + 0.5 - k_.cy) / k_.fy, 1);
        return pose_.R.transpose() * (ray * depth(x, y) - pose_.t);
    }
    Intrinsics k_;
    Pose pose_;
    int width_ = 0, height_ = 0;
    std::vector<float> z_;
};

/// Maps pixels of `b` to pixels of `a` along the surface's tangent plane.
Matrix2d along_surface(const GivenCamera& a, const GivenCamera& b, const Place& at) {
    return a.of_point(at.x) * at.tangents * (b.of_point(at.x) * at.tangents).inverse();
}

/// If camera errors displace the surface by e_a in `a` and by e_b in `b`, a match is displaced by M e_b -
/// e_a, where M maps pixels of `b` to pixels of `a` along the surface.
std::optional<CellDisplacement> cell_at(const GivenCamera& a, const GivenCamera& b, const Place& at) {
    const auto in_a = project(a.k, a.pose, at.x), in_b = project(b.k, b.pose, at.x);
    if (!in_a || !in_b) return {};
    const Matrix2d m = along_surface(a, b, at);
    if (!m.allFinite() || !(m.norm() <= max_stretch)) return {};
    CellDisplacement out;
    out.pose_a = -a.of_pose(at.x), out.pose_b = m * b.of_pose(at.x);
    out.lens_a = -a.of_lens(in_a->pixel), out.lens_b = m * b.of_lens(in_b->pixel);
    return out;
}

/// Adds the derivatives with respect to a common motion of all cameras about the center of all points.
void add_frame(CellDisplacements& out, std::span<const GivenCamera> cameras,
               std::span<const std::vector<Place>> places) {
    double n = 0;
    Vector3d sum = Vector3d::Zero();
    std::vector<double> units;
    for (std::size_t p = 0; p < places.size(); ++p)
        for (const Place& at : places[p]) {
            sum += at.x, ++n;
            units.push_back(cameras[out.pairs[p].a].distance / cameras[out.pairs[p].a].focal());
        }
    if (n == 0) return;
    out.frame.middle = sum / n;
    out.frame.size = 0;
    for (const auto& of_pair : places)
        for (const Place& at : of_pair) out.frame.size += (at.x - out.frame.middle).norm() / n;
    if (!(out.frame.size > 0)) return;
    out.frame_unit = quantile(std::move(units), 0.5) / out.frame.size;
    for (std::size_t p = 0; p < places.size(); ++p)
        for (std::size_t c = 0; c < places[p].size(); ++c) {
            const GivenCamera &a = cameras[out.pairs[p].a], &b = cameras[out.pairs[p].b];
            const Place& at = places[p][c];
            CellDisplacement& cell = out.pairs[p].cells[c];
            cell.seen = out.frame_unit * motion_derivative(a.k, a.pose, at.x, out.frame);
            cell.frame =
                out.frame_unit * along_surface(a, b, at) * motion_derivative(b.k, b.pose, at.x, out.frame) -
                cell.seen;
        }
}

}  // namespace

CellDisplacements cell_displacements(const PoseRefinementInput& in, std::span<const PairRecord> pairs) {
    CellDisplacements out;
    const std::vector<GivenCamera> cameras(in.photos.begin(), in.photos.end());
    std::vector<std::vector<Place>> places;
    std::optional<Surface> surface;
    std::optional<std::uint32_t> of;
    for (const PairRecord& p : pairs) {
        if (!trusted(p)) continue;
        if (of != p.a) surface.emplace(in, p.a), of = p.a;
        out.pairs.push_back({p.a, p.b, {}});
        places.emplace_back();
        for (int c = 0; c < columns * rows; ++c) {
            const PairRecord::Cell& cell = p.cells[c];
            if (cell.matches == 0) continue;
            const auto place = surface->at((c % columns + 0.5) / columns, (c / columns + 0.5) / rows);
            auto found = place ? cell_at(cameras[p.a], cameras[p.b], *place) : std::nullopt;
            if (!found) continue;
            found->moved = Vector2d(cell.moved[0], cell.moved[1]) / 64;
            found->weight = std::min(double(cell.matches), max_weight);
            found->odd = (c % columns + c / columns) % 2;
            out.pairs.back().cells.push_back(*found);
            places.back().push_back(*place);
        }
    }
    add_frame(out, cameras, places);
    return out;
}

}  // namespace vantage
