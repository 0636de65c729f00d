#include "pipeline/stages/coordinates/footprint_hull.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "base/values/simd.h"

namespace vantage {
namespace {

/// Corners of a convex polygon in angular order; some may coincide.
using Octagon = std::array<Eigen::Vector2f, 8>;

/// The extreme points in eight directions: left, upper left, up, and so on.
Octagon extreme_points(const std::vector<Eigen::Vector2f>& points) {
    Octagon out;
    out.fill(points.front());
    std::array<float, 8> farthest;
    farthest.fill(-std::numeric_limits<float>::infinity());
    for (const Eigen::Vector2f& p : points) {
        const float sum = p.x() + p.y(), difference = p.x() - p.y();
        const float along[8] = {-p.x(), -sum, -p.y(), difference, p.x(), sum, p.y(), -difference};
        for (std::size_t i = 0; i < 8; ++i)
            if (along[i] > farthest[i]) farthest[i] = along[i], out[i] = p;
    }
    return out;
}

/// Sets `inside` to 1 for the points strictly inside the octagon.
VANTAGE_SIMD void find_inside(const Octagon& octagon, const float* points, std::size_t count,
                              std::uint8_t* inside) {
    std::fill_n(inside, count, std::uint8_t(1));
    for (std::size_t side = 0; side < octagon.size(); ++side) {
        const Eigen::Vector2f from = octagon[side], along = octagon[(side + 1) % octagon.size()] - from;
        if (along.isZero(0)) continue;
        const float x = from.x(), y = from.y(), dx = along.x(), dy = along.y();
        for (std::size_t i = 0; i < count; ++i)
            inside[i] &= std::uint8_t(dx * (points[2 * i + 1] - y) - dy * (points[2 * i] - x) > 0);
    }
}

/// Drops the points inside the polygon of extreme points, which cannot be on the hull (Akl and Toussaint
/// 1978).
std::vector<cv::Point2f> outer_points(const std::vector<Eigen::Vector2f>& points) {
    const Octagon octagon = extreme_points(points);
    const bool single_point = std::ranges::all_of(octagon, [&](const auto& p) { return p == octagon[0]; });
    std::vector<std::uint8_t> inside(points.size(), 0);
    if (!single_point) find_inside(octagon, points.front().data(), points.size(), inside.data());
    std::vector<cv::Point2f> outer;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (!inside[i]) outer.emplace_back(points[i].x(), points[i].y());
    return outer;
}

}  // namespace

FootprintHull footprint_hull(const std::vector<Eigen::Vector2f>& coordinates, const Intrinsics& k,
                             const Pose& pose) {
    std::vector<Eigen::Vector2f> seen;
    seen.reserve(coordinates.size());
    std::ranges::copy_if(coordinates, std::back_inserter(seen), [](const auto& uv) { return uv.x() >= 0; });
    if (seen.empty()) return {pose.direction(), 0};
    std::vector<cv::Point2f> hull;
    cv::convexHull(outer_points(seen), hull);
    const double area = cv::contourArea(hull);
    Eigen::Vector2d center = Eigen::Vector2d::Zero();
    const cv::Moments m = cv::moments(hull);
    if (m.m00 > 1e-9) {
        center = {m.m10 / m.m00, m.m01 / m.m00};
    } else {
        for (const cv::Point2f& p : hull) center += Eigen::Vector2d(p.x, p.y) / double(hull.size());
    }
    const Eigen::Vector3d ray((center.x() * k.width - k.cx) / k.fx, (center.y() * k.height - k.cy) / k.fy, 1);
    return {(pose.R.transpose() * ray).normalized(), std::clamp(area, 0.0, 1.0)};
}

}  // namespace vantage
