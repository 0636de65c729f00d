#include "pipeline/presentation/kind_of_scan.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/values/quantile.h"

namespace vantage {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

constexpr double least_arc = 150 * pi / 180;               ///< minimum range of azimuths for an object
constexpr double faces_outward = 0.6, faces_inward = 0.4;  ///< fractions of the surface

/// The centers of visible discs, and their normals, turned toward the photos that show them.
struct Facing {
    std::vector<Vector3d> centers, normals;
};

Facing facing_photos(std::span<const Pose> poses, Samples samples, std::span<const SurfaceDisc> discs) {
    Facing out;
    for (std::size_t d = 0; d < discs.size(); ++d) {
        Vector3d toward = Vector3d::Zero();
        const Vector3d center = discs[d].center.cast<double>(), normal = discs[d].normal.cast<double>();
        for (std::size_t p = 0; p < samples.size(); ++p)
            if (d < samples[p].size() && shown(samples[p][d]))
                toward += (poses[p].center() - center).normalized();
        if (!(std::abs(toward.dot(normal)) > 0)) continue;
        out.centers.push_back(center);
        out.normals.push_back(toward.dot(normal) < 0 ? Vector3d(-normal) : normal);
    }
    return out;
}

/// The largest gap in azimuth between cameras as seen from `middle`, in radians; azimuths are measured about
/// `up`.
double largest_gap(std::span<const Pose> poses, const Vector3d& middle, const Vector3d& up) {
    const Vector3d east = up.unitOrthogonal(), north = up.cross(east);
    std::vector<double> azimuths;
    for (const Pose& pose : poses) {
        const Vector3d from = pose.center() - middle;
        if (std::hypot(from.dot(east), from.dot(north)) > 0.1 * from.norm())
            azimuths.push_back(std::atan2(from.dot(north), from.dot(east)));
    }
    if (azimuths.empty()) return 2 * pi;
    std::ranges::sort(azimuths);
    double gap = azimuths.front() + 2 * pi - azimuths.back();
    for (std::size_t i = 1; i < azimuths.size(); ++i) gap = std::max(gap, azimuths[i] - azimuths[i - 1]);
    return gap;
}

/// Whether most cameras have surfaces on both sides along all three axes.
bool among(std::span<const Pose> poses, const std::vector<Vector3d>& centers, const Vector3d& up) {
    const Vector3d east = up.unitOrthogonal(), north = up.cross(east);
    std::vector<bool> inside(poses.size(), true);
    for (const Vector3d& axis : {up, east, north}) {
        std::vector<double> along;
        for (const Vector3d& c : centers) along.push_back(axis.dot(c));
        const double low = quantile(along, 0.02), high = quantile(along, 0.98);
        for (std::size_t i = 0; i < poses.size(); ++i) {
            const double at = axis.dot(poses[i].center());
            if (!(at > low && at < high)) inside[i] = false;
        }
    }
    return 2 * std::size_t(std::ranges::count(inside, true)) > poses.size();
}

}  // namespace

KindOfScan kind_of_scan(std::span<const Pose> poses, Samples samples, std::span<const SurfaceDisc> discs,
                        const Vector3d& up) {
    const Facing surface = facing_photos(poses, samples, discs);
    if (surface.centers.empty()) return KindOfScan::front;
    Vector3d middle = Vector3d::Zero();
    for (const Vector3d& c : surface.centers) middle += c / double(surface.centers.size());
    double outward = 0, inward = 0;
    for (std::size_t i = 0; i < surface.centers.size(); ++i) {
        const Vector3d from = (surface.centers[i] - middle).normalized();
        const double along = from.dot(surface.normals[i]);
        outward += along > 0.1;
        inward += along < -0.1;
    }
    const double share = (outward + 1e-9) / (outward + inward + 2e-9);
    const bool around = largest_gap(poses, middle, up) < 2 * pi - least_arc;
    if (share < faces_inward && among(poses, surface.centers, up)) return KindOfScan::inside;
    return around && share > faces_outward ? KindOfScan::object : KindOfScan::front;
}

}  // namespace vantage
