#include "pipeline/refine/poses/common_motion.h"

#include <Eigen/Geometry>
#include <cmath>

#include "base/values/quantile.h"

namespace vantage {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Calls visit(photo) for every photo that shows the track.
template <class Visit>
void for_each_photo_of(const Track& track, const Visit& visit) {
    visit(track.photo);
    for (const Match& m : track.matches) visit(m.photo);
}

}  // namespace

Eigen::Matrix<double, 2, 3> pixel_derivative(const Intrinsics& k, const Vector3d& p) {
    Eigen::Matrix<double, 2, 3> out;
    out << k.fx / p.z(), 0, -k.fx * p.x() / (p.z() * p.z()), 0, k.fy / p.z(), -k.fy * p.y() / (p.z() * p.z());
    return out;
}

Eigen::Matrix<double, 2, 7> motion_derivative(const Intrinsics& k, const Pose& pose, const Vector3d& x,
                                              const MotionFrame& frame) {
    const Vector3d from_middle = x - frame.middle;
    Eigen::Matrix<double, 3, 7> of_point;
    for (int a = 0; a < 3; ++a) {
        of_point.col(a) = Vector3d::Unit(a).cross(from_middle);
        of_point.col(3 + a) = Vector3d::Unit(a) * frame.size;
    }
    of_point.col(6) = from_middle;
    return pixel_derivative(k, pose.R * x + pose.t) * pose.R * of_point;
}

Similarity common_motion(std::span<const Intrinsics> intrinsics, std::span<const Pose> given,
                         std::span<const Pose> now, std::span<const Track> tracks) {
    if (tracks.empty()) return {};
    MotionFrame frame{Vector3d::Zero(), 0};
    for (const Track& s : tracks) frame.middle += s.point / double(tracks.size());
    for (const Track& s : tracks) frame.size += (s.point - frame.middle).norm() / double(tracks.size());
    // A single point determines neither rotation nor scale.
    const Pose& first = given[tracks.front().photo];
    if (!(frame.size > 1e-9 * (first.R * frame.middle + first.t).norm())) return {};
    NormalEquations sums;
    for (const Track& s : tracks)
        for_each_photo_of(s, [&](std::uint32_t i) {
            const auto a = project(intrinsics[i], given[i], s.point),
                       b = project(intrinsics[i], now[i], s.point);
            if (!a || !b) return;
            const auto j = motion_derivative(intrinsics[i], given[i], s.point, frame);
            sums.normal += j.transpose() * j;
            sums.right += j.transpose() * (b->pixel - a->pixel);
        });
    const SmallMotion d = solved(sums);
    if (!d.allFinite() || std::abs(d(6)) > 1) return {};
    return similarity(d, frame);
}

double median_motion(std::span<const Intrinsics> intrinsics, std::span<const Pose> a, std::span<const Pose> b,
                     std::span<const Track> tracks, std::optional<std::uint32_t> photo) {
    std::vector<double> moved;
    for (const Track& s : tracks)
        for_each_photo_of(s, [&](std::uint32_t i) {
            if (photo && *photo != i) return;
            const auto p = project(intrinsics[i], a[i], s.point), q = project(intrinsics[i], b[i], s.point);
            if (p && q) moved.push_back((p->pixel - q->pixel).norm());
        });
    return quantile(std::move(moved), 0.5);
}

}  // namespace vantage
