#include "player/plan/frustum.h"

#include <algorithm>
#include <cmath>

namespace vantage {
namespace {

constexpr double rounding = 1e-12;  // error of a distance from a plane, relative to its terms

/// The sides of an orthographic view are parallel to its axis.
Frustum beam(const View& view) {
    const Intrinsics& k = view.intrinsics;
    const Pose& pose = view.cam_from_origin;
    const Eigen::Vector3d right = pose.R.row(0), down = pose.R.row(1);
    const double across = view.orthographic_depth / k.fx, along = view.orthographic_depth / k.fy;
    return {
        HalfSpace{right, pose.t.x() + k.cx * across},
        HalfSpace{-right, (k.width - k.cx) * across - pose.t.x()}, HalfSpace{down, pose.t.y() + k.cy * along},
        HalfSpace{-down, (k.height - k.cy) * along - pose.t.y()}, HalfSpace{pose.direction(), pose.t.z()}};
}

}  // namespace

Frustum frustum(const View& view) {
    if (view.orthographic_depth > 0) return beam(view);
    const Intrinsics& k = view.intrinsics;
    const Pose& pose = view.cam_from_origin;
    const std::array<Eigen::Vector3d, 5> in_camera{
        Eigen::Vector3d(k.fx, 0, k.cx).normalized(), Eigen::Vector3d(-k.fx, 0, k.width - k.cx).normalized(),
        Eigen::Vector3d(0, k.fy, k.cy).normalized(), Eigen::Vector3d(0, -k.fy, k.height - k.cy).normalized(),
        Eigen::Vector3d::UnitZ()};
    Frustum planes;
    for (std::size_t i = 0; i < 5; ++i)
        planes[i] = {pose.R.transpose() * in_camera[i], in_camera[i].dot(pose.t)};
    return planes;
}

Side side_of(const Frustum& planes, const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
    const Eigen::Vector3d middle = (low + high) / 2, half = (high - low) / 2;
    Side side = Side::inside;
    for (const HalfSpace& p : planes) {
        const double distance = p.normal.dot(middle) + p.offset,
                     reach = p.normal.cwiseAbs().dot(half) * (1 + 1e-5) +
                             rounding * (middle.norm() + std::abs(p.offset));
        if (distance < -reach) return Side::outside;
        if (distance < reach) side = Side::across;
    }
    return side;
}

bool reaches(const Frustum& planes, const Eigen::Vector3d& center, double radius) {
    return std::ranges::all_of(planes, [&](const HalfSpace& plane) {
        const double reach = radius * (1 + 1e-5) + rounding * (center.norm() + std::abs(plane.offset));
        return plane.normal.dot(center) + plane.offset >= -reach;
    });
}

}  // namespace vantage
