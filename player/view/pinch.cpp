#include "player/view/pinch.h"

#include <Eigen/Geometry>
#include <cmath>

namespace vantage {

Pinch pinch_between(const FingerPair& before, const FingerPair& now) {
    constexpr double least_distance = 8;  // pixels
    Pinch out;
    out.center = (now[0] + now[1]) / 2;
    out.moved = out.center - (before[0] + before[1]) / 2;
    const Eigen::Vector2d was = before[1] - before[0], is = now[1] - now[0];
    if (was.norm() < least_distance || is.norm() < least_distance) return out;
    out.spread = is.norm() / was.norm();
    out.turned = std::atan2(was.x() * is.y() - was.y() * is.x(), was.dot(is));
    return out;
}

Pinch then(const Pinch& first, const Pinch& second) {
    return {second.center, first.moved + second.moved, first.spread * second.spread,
            first.turned + second.turned};
}

void follow_pinch(Navigation& n, const Pinch& p, const Eigen::Vector3d& point, const View& view,
                  double nearest, double farthest) {
    const double pixel = std::abs(depth_in(view, point)) / view.intrinsics.fx;
    fly(n, -pixel * Eigen::Vector3d(p.moved.x(), p.moved.y(), 0));
    if (p.spread > 0 && p.spread != 1) approach_point(n, point, 1 / p.spread, nearest, farthest);
    const Eigen::Vector3d axis = n.R.row(2), sight = view.orthographic_depth > 0 ? axis : point - n.eye;
    if (p.turned == 0 || !(sight.norm() > 0)) return;
    // The world turns with the fingers, clockwise about the viewing direction.
    const Eigen::Matrix3d world = Eigen::AngleAxisd(p.turned, sight.normalized()).toRotationMatrix();
    n.R = n.R * world;
    n.eye = point + world.transpose() * (n.eye - point);
    n.target = point + world.transpose() * (n.target - point);
}

}  // namespace vantage
