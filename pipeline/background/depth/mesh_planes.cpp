#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>

#include "base/values/principal_axes.h"
#include "pipeline/background/depth/planes.h"
#include "pipeline/presentation/up_direction.h"

namespace vantage {
namespace {

constexpr std::size_t max_planes = 3;
constexpr int plane_tries = 300;
constexpr std::size_t max_compared = 5000;  ///< discs per trial
/// The thickness is relative to the mesh's extent.
constexpr double least_plane_share = 0.04, thickness = 0.01;
constexpr float same_way = 0.9f;       ///< cosine between normals
constexpr double level = 0.966;        ///< cosine between a floor's normal and down
constexpr double least_floor = 0.004;  ///< fraction of the discs

using Disc = SurfaceDisc;

/// The diagonal of the box between the 2nd and 98th percentiles.
double extent_of(std::span<const Disc> discs) {
    Eigen::Vector3d extent;
    std::vector<float> values(discs.size());
    for (int c = 0; c < 3; ++c) {
        std::ranges::transform(discs, values.begin(), [c](const Disc& d) { return d.center[c]; });
        std::ranges::sort(values);
        extent[c] = double(values[values.size() * 49 / 50] - values[values.size() / 50]);
    }
    return extent.norm();
}

Plane fitted(const std::vector<const Disc*>& discs) {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Disc* d : discs) mean += d->center.cast<double>() / double(discs.size());
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const Disc* d : discs) {
        const Eigen::Vector3d off = d->center.cast<double>() - mean;
        scatter += off * off.transpose();
    }
    const Eigen::Vector3d normal = principal_axes(scatter).axes.col(0);
    return {normal, normal.dot(mean)};
}

bool lies_on(const Disc& d, const Disc& seed, double thick) {
    return std::abs((d.center - seed.center).dot(seed.normal)) < thick &&
           std::abs(d.normal.dot(seed.normal)) > same_way;
}

/// Among a number of random discs, the one with the most other discs on its plane.
const Disc& best_seed(const std::vector<const Disc*>& discs, double thick, std::mt19937_64& random) {
    // A sample is enough to compare the seeds.
    std::vector<Disc> sample;
    for (std::size_t i = 0; i < discs.size(); i += 1 + discs.size() / max_compared)
        sample.push_back(*discs[i]);
    const Disc* best = discs.front();
    std::ptrdiff_t most = 0;
    for (int i = 0; i < plane_tries; ++i) {
        const Disc* seed = discs[random() % discs.size()];
        const auto on =
            std::ranges::count_if(sample, [&](const Disc& d) { return lies_on(d, *seed, thick); });
        if (on > most) most = on, best = seed;
    }
    return *best;
}

std::vector<Plane> largest_planes(std::vector<const Disc*> left, double thick) {
    std::vector<Plane> planes;
    std::mt19937_64 random(1);
    const double least = least_plane_share * double(left.size());
    while (planes.size() < max_planes && double(left.size()) > least) {
        const Disc& seed = best_seed(left, thick, random);
        std::vector<const Disc*> on;
        std::ranges::copy_if(left, std::back_inserter(on),
                             [&](const Disc* d) { return lies_on(*d, seed, thick); });
        if (double(on.size()) < least) break;
        const Plane plane = planes.emplace_back(fitted(on));
        std::erase_if(left, [&](const Disc* d) {
            return std::abs(plane.normal.dot(d->center.cast<double>()) - plane.height) < thick;
        });
    }
    return planes;
}

/// The level plane below `top` with the most discs near it. The plane's tilt is not fitted: a strip of floor
/// in front of a wall hardly determines it, and the background is far away.
std::optional<Plane> level_floor(const std::vector<const Disc*>& discs, const Eigen::Vector3d& down,
                                 double top, double thick) {
    std::vector<double> heights;
    for (const Disc* d : discs)
        if (const double h = down.dot(d->center.cast<double>());
            h > top && std::abs(down.dot(d->normal.cast<double>())) > level)
            heights.push_back(h);
    std::ranges::sort(heights);
    std::size_t most = 0, first = 0;
    for (std::size_t i = 0, end = 0; i < heights.size(); ++i) {
        while (end < heights.size() && heights[end] - heights[i] <= thick) ++end;
        if (end - i > most) most = end - i, first = i;
    }
    if (most < 3 || double(most) < least_floor * double(discs.size())) return std::nullopt;
    return Plane{down, heights[first + most / 2]};
}

/// The largest plane that is nearly level and below all cameras.
std::optional<Plane> floor_among(const std::vector<Plane>& planes, std::span<const CoarseView> views,
                                 const Eigen::Vector3d& held) {
    for (const Plane& p : planes) {
        const double sign = p.normal.dot(held) < 0 ? -1 : 1;
        const Plane floor{sign * p.normal, sign * p.height};
        if (floor.normal.dot(held) > level && floor.height > lowest_camera(views, floor.normal)) return floor;
    }
    return std::nullopt;
}

}  // namespace

MeshPlanes mesh_planes(std::span<const Disc> discs, std::span<const CoarseView> views) {
    std::vector<const Disc*> usable;
    for (const Disc& d : discs)
        if (d.normal.squaredNorm() > 0) usable.push_back(&d);
    if (usable.size() < 100 || views.empty()) return {};
    const double thick = thickness * extent_of(discs);
    MeshPlanes out;
    out.largest = largest_planes(usable, thick);
    const Eigen::Vector3d held = down_direction(views);
    if (const auto up = up_of_surface(discs, -held)) out.down = -*up;
    out.floor = out.down ? level_floor(usable, *out.down, lowest_camera(views, *out.down), thick)
                         : floor_among(out.largest, views, held);
    return out;
}

}  // namespace vantage
