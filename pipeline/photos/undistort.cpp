#include "pipeline/photos/undistort.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

namespace vantage {
namespace {

/// The pixel at which the lens images what a pinhole camera images at (u, v); NaN if the ray is beyond
/// `range`, the lens's lens_range().
Eigen::Vector2d distorted_pixel(const Camera& camera, double range, double u, double v) {
    const Intrinsics& k = camera.intrinsics;
    const Eigen::Vector2d ray((u - k.cx) / k.fx, (v - k.cy) / k.fy);
    if (!(ray.norm() <= range)) return Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
    const Eigen::Vector2d d = distort(camera.lens, ray);
    return {k.fx * d.x() + k.cx, k.fy * d.y() + k.cy};
}

}  // namespace

double largest_displacement(const Camera& camera) {
    if (!camera.lens.distorts()) return 0;
    constexpr int n = 32;
    const double range = lens_range(camera.lens);
    double largest = 0;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            const Eigen::Vector2d p(double(i) * camera.intrinsics.width / n,
                                    double(j) * camera.intrinsics.height / n);
            const double d = (distorted_pixel(camera, range, p.x(), p.y()) - p).norm();
            if (std::isfinite(d)) largest = std::max(largest, d);
        }
    return largest;
}

RgbaImage undistort(const RgbaImage& photo, const Camera& camera) {
    const double range = lens_range(camera.lens);
    cv::Mat map(photo.height, photo.width, CV_32FC2);
    for (int y = 0; y < photo.height; ++y)
        for (int x = 0; x < photo.width; ++x) {
            // OpenCV's pixel centers are at integers.
            const Eigen::Vector2d p = distorted_pixel(camera, range, x + 0.5, y + 0.5).array() - 0.5;
            const bool usable = p.allFinite() && p.cwiseAbs().maxCoeff() < 1e6;
            map.at<cv::Vec2f>(y, x) =
                usable ? cv::Vec2f(float(p.x()), float(p.y())) : cv::Vec2f(-1e6f, -1e6f);
        }
    RgbaImage out = blank_image(photo.width, photo.height);
    const cv::Mat from(photo.height, photo.width, CV_8UC4, const_cast<std::uint8_t*>(photo.rgba.data()));
    cv::Mat to(out.height, out.width, CV_8UC4, out.rgba.data());
    cv::remap(from, to, map, {}, cv::INTER_CUBIC, cv::BORDER_REPLICATE);
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            const cv::Vec2f p = map.at<cv::Vec2f>(y, x);
            const bool inside = p[0] >= -0.5f && p[1] >= -0.5f && p[0] <= float(photo.width) - 0.5f &&
                                p[1] <= float(photo.height) - 0.5f;
            if (!inside) to.at<cv::Vec4b>(y, x) = {0, 0, 0, 0};
        }
    return out;
}

}  // namespace vantage
