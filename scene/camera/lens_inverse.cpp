#include "scene/camera/lens_inverse.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace vantage {
namespace {

/// The ray in direction `xy` whose image is as far from the center as `xy`.
Eigen::Vector2d by_bisection(const Lens& lens, double range, const Eigen::Vector2d& xy) {
    const double radius = xy.norm();
    if (radius == 0) return xy;
    const Eigen::Vector2d along = xy / radius;
    double low = 0, high = std::min(range, 1e4);
    for (int i = 0; i < 40; ++i) {
        const double middle = (low + high) / 2;
        (distort(lens, along * middle).norm() < radius ? low : high) = middle;
    }
    return along * low;
}

/// The Jacobian of distort(), computed by central differences.
Eigen::Matrix2d jacobian(const Lens& lens, const Eigen::Vector2d& at) {
    const double step = 1e-6 * std::max(1.0, at.norm());
    Eigen::Matrix2d J;
    for (int i = 0; i < 2; ++i) {
        const Eigen::Vector2d d = step * Eigen::Vector2d::Unit(i);
        J.col(i) = (distort(lens, at + d) - distort(lens, at - d)) / (2 * step);
    }
    return J;
}

}  // namespace

std::optional<Eigen::Vector2d> undistort(const Lens& lens, double range, const Eigen::Vector2d& xy) {
    if (!lens.distorts()) return xy;
    if (!xy.allFinite()) return {};
    Eigen::Vector2d at = by_bisection(lens, range, xy);
    for (int i = 0; i < 20; ++i) {
        const Eigen::Vector2d step = jacobian(lens, at).inverse() * (distort(lens, at) - xy);
        if (!step.allFinite()) return {};
        at -= step;
        if (step.norm() <= 1e-14 * std::max(1.0, at.norm())) break;
    }
    const bool found =
        at.norm() <= range && (distort(lens, at) - xy).norm() <= 1e-9 * std::max(1.0, xy.norm());
    return found ? std::optional(at) : std::nullopt;
}

}  // namespace vantage
