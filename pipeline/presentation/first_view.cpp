#include "pipeline/presentation/first_view.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>
#include <vector>

#include "base/values/angle_between.h"
#include "base/values/principal_axes.h"
#include "base/values/quantile.h"
#include "scene/package/package_reader.h"

namespace vantage {
namespace {

using Eigen::Vector3d;

constexpr double degree = std::numbers::pi / 180;
constexpr double filled = 0.75;                ///< fraction of the frame's height or width
constexpr double least_fov = 8, max_fov = 70;  ///< degrees
constexpr double nearby = 25 * degree;         ///< angle at the model between nearby photos
constexpr double tolerated_roll = 15 * degree, usual_height = 40 * degree;
constexpr double usual_distance = 0.5;  ///< width of the bell curve, in ln(distance / median)
constexpr int cells = 24;               ///< along the model's longest side; detail is measured per cell

/// The amount of detail at each disc: how much the normals and colors of nearby discs vary.
std::vector<double> detail_of(Samples samples, std::span<const SurfaceDisc> discs) {
    struct Cell {
        Eigen::Matrix3d normals = Eigen::Matrix3d::Zero();
        double light = 0, squares = 0, colored = 0, detail = 0;
    };
    Eigen::AlignedBox3f box;
    for (const SurfaceDisc& d : discs) box.extend(d.center);
    const float size = std::max(box.sizes().maxCoeff() / cells, 1e-30f);
    std::map<std::tuple<int, int, int>, Cell> grid;
    const auto cell_of = [&](const SurfaceDisc& d) -> Cell& {
        const Eigen::Vector3f at = (d.center - box.min()) / size;
        return grid[{int(at.x()), int(at.y()), int(at.z())}];
    };
    for (std::size_t i = 0; i < discs.size(); ++i) {
        Cell& cell = cell_of(discs[i]);
        const Vector3d n = discs[i].normal.cast<double>();
        cell.normals += n * n.transpose();
        for (const auto& of : samples)
            if (i < of.size() && shown(of[i])) {
                const double light =
                    std::sqrt((of[i].linear[0] + 2.0 * of[i].linear[1] + of[i].linear[2]) / 4 / 65535);
                cell.light += light, cell.squares += light * light, ++cell.colored;
                break;
            }
    }
    const auto worth = [](const Cell& cell) {
        // The fraction of the normals' squared lengths that is not along their main direction.
        const double bent = 1 - principal_axes(cell.normals).values[2] / std::max(cell.normals.trace(), 1e-9);
        const double n = std::max(cell.colored, 1.0), mean = cell.light / n;
        return 0.05 + bent + 2 * std::sqrt(std::max(cell.squares / n - mean * mean, 0.0));
    };
    for (auto& [place, cell] : grid) cell.detail = worth(cell);
    std::vector<double> out;
    for (const SurfaceDisc& d : discs) out.push_back(cell_of(d).detail);
    return out;
}

/// A candidate for the first photo.
struct Candidate {
    std::uint32_t photo;
    Pose pose;
    double detail = 0;    ///< amount of detail in the photo
    Vector3d from;        ///< unit direction from the model's center
    double distance = 0;  ///< distance to the visible surface
    double height = 0;    ///< elevation of the camera above the horizon, radians
};

std::vector<Candidate> candidates(std::span<const package::PhotoRecord> photos, Samples samples,
                                  std::span<const SurfaceDisc> discs, const Vector3d& up) {
    const std::vector<double> detail = detail_of(samples, discs);
    Vector3d middle = Vector3d::Zero();
    for (const SurfaceDisc& d : discs) middle += d.center.cast<double>() / double(discs.size());
    std::vector<Candidate> out;
    for (std::uint32_t p = 0; p < photos.size(); ++p) {
        if (!photos[p].levels || photos[p].image_set || p >= samples.size() || samples[p].empty()) continue;
        Candidate c{p, cam_from_origin(photos[p]), 0, {}, photos[p].seen_distance, 0};
        c.from = (c.pose.center() - middle).normalized();
        c.height = std::asin(std::clamp(c.from.dot(up), -1.0, 1.0));
        for (std::size_t d = 0; d < std::min(discs.size(), samples[p].size()); ++d)
            if (shown(samples[p][d])) {
                const Vector3d toward = (c.pose.center() - discs[d].center.cast<double>()).normalized();
                c.detail += detail[d] * std::abs(toward.dot(discs[d].normal.cast<double>()));
            }
        if (c.detail > 0 && c.distance > 0) out.push_back(c);
    }
    return out;
}

double bell(double x, double width) { return std::exp(-x * x / (width * width)); }

const Candidate& best_of(const std::vector<Candidate>& all, const Vector3d& up) {
    std::vector<double> distances, heights;
    for (const Candidate& c : all) distances.push_back(c.distance), heights.push_back(c.height);
    const double distance = quantile(distances, 0.5), height = std::clamp(quantile(heights, 0.5), -0.2, 0.6);
    const auto score = [&](const Candidate& c) {
        double company = 0;
        for (const Candidate& o : all) company += bell(angle_between(c.from, o.from), nearby);
        const double roll = std::asin(std::clamp(Vector3d(c.pose.R.row(0)).dot(up), -1.0, 1.0));
        return c.detail * std::sqrt(company) * bell(std::log(c.distance / distance), usual_distance) *
               (0.3 + 0.7 * bell(roll, tolerated_roll)) * bell(c.height - height, usual_height);
    };
    return *std::ranges::max_element(all, {}, score);
}

/// The range of points around a viewing direction, as tangents of the angles: from a low quantile to a high
/// one.
struct Extent {
    double low, high;
    double middle() const { return (low + high) / 2; }
    double half() const { return (high - low) / 2; }
};

Extent extent_of(std::vector<double> tangents, double radius) {
    return {quantile(tangents, 0.01) - radius, quantile(tangents, 0.99) + radius};
}

/// Turns and zooms the view so that it frames `points`, the centers of discs.
void frame(FirstView& view, const Vector3d& eye, const Vector3d& up, std::span<const Vector3d> points,
           double radius) {
    double distance = 0;
    for (const Vector3d& p : points) distance += (p - eye).norm() / double(points.size());
    Vector3d ahead = Vector3d::Zero();
    for (const Vector3d& p : points) ahead += (p - eye).normalized();
    for (int round = 0; round < 4; ++round) {
        ahead.normalize();
        Vector3d right = ahead.cross(up);
        if (!(right.norm() > 1e-6)) right = ahead.unitOrthogonal();
        right.normalize();
        const Vector3d down = ahead.cross(right);
        std::vector<double> x, y;
        for (const Vector3d& p : points)
            if (const double z = (p - eye).dot(ahead); z > 1e-6 * distance)
                x.push_back((p - eye).dot(right) / z), y.push_back((p - eye).dot(down) / z);
        if (x.empty() || !(distance > 0)) return;
        const Extent wide = extent_of(std::move(x), radius / distance),
                     high = extent_of(std::move(y), radius / distance);
        view.target = eye + distance * ahead;
        const double half = std::max(high.half(), 1e-3);
        view.aspect = std::clamp(wide.half() / half, 0.1, 10.0);
        view.fov = std::clamp(2 * std::atan(half / filled) / degree, least_fov, max_fov);
        ahead += wide.middle() * right + high.middle() * down;
    }
}

/// Sets the view to the frame of the photo.
void frame_as(FirstView& view, const package::PhotoRecord& photo) {
    const Pose pose = cam_from_origin(photo);
    view.target = pose.center() + seen_distance(photo) * pose.direction();
    view.fov = std::clamp(2 * std::atan(photo.height / (2 * photo.fy)) / degree, least_fov, 150.0);
    view.aspect = std::clamp(double(photo.width) / photo.height, 0.1, 10.0);
}

}  // namespace

FirstView first_view(std::span<const package::PhotoRecord> photos, Samples samples,
                     std::span<const SurfaceDisc> discs, const Vector3d& up, KindOfScan kind) {
    FirstView view{.photo = photos.size()};
    for (std::size_t p = photos.size(); p-- > 0;)
        if (photos[p].levels && !photos[p].image_set) view.photo = p;
    if (view.photo == photos.size()) return view;
    const std::vector<Candidate> all = candidates(photos, samples, discs, up);
    if (!all.empty()) view.photo = best_of(all, up).photo;
    frame_as(view, photos[view.photo]);
    if (all.empty() || kind == KindOfScan::inside) return view;
    std::vector<Vector3d> points;
    for (std::size_t d = 0; d < discs.size(); ++d) {
        const auto shows = [&](std::size_t p) { return d < samples[p].size() && shown(samples[p][d]); };
        bool part = shows(view.photo);
        for (std::size_t p = 0; kind == KindOfScan::object && !part && p < samples.size(); ++p)
            part = shows(p);
        if (part) points.push_back(discs[d].center.cast<double>());
    }
    frame(view, cam_from_origin(photos[view.photo]).center(), up, points,
          points.empty() ? 0 : discs[0].radius);
    return view;
}

}  // namespace vantage
