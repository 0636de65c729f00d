#include "pipeline/refine/poses/surface_matches.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

#include "base/values/simd.h"
#include "pipeline/refine/coarse_photo.h"

namespace vantage {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double block = 16;              ///< distance between corners, pixels of the level
constexpr double max_round_trip = 0.75;   ///< largest error after tracking back, pixels of the level
constexpr double min_correlation = 0.75;  ///< over `patch`
const cv::Size patch(13, 13);
const cv::Size window(15, 15);  ///< of optical flow
constexpr int levels = 3;       ///< pyramid levels in addition to the first

Vector2d to_vector(const cv::Point2f& p) { return {double(p.x), double(p.y)}; }

/// The mapping from one camera's pixels to those of another.
struct Reprojection {
    Eigen::Matrix3f R;
    Eigen::Vector3f t;
    float fx, fy, cx, cy;
};

/// A row of pixels as seen by another camera: their positions and depths.
struct ReprojectedRow {
    float *u, *v, *depth;
};

/// Reprojects pixels at depths `z` on the rays (x, y, 1). The result is undefined where z is infinite.
VANTAGE_SIMD void reproject_row(const Reprojection& to, const float* z, const float* ray_x, float ray_y,
                                int width, const ReprojectedRow& row) {
    float *u = row.u, *v = row.v, *depth = row.depth;
    const Eigen::Matrix3f R = to.R;
    const Eigen::Vector3f t = to.t;
    const float fx = to.fx, fy = to.fy, cx = to.cx - 0.5f, cy = to.cy - 0.5f;
    for (int x = 0; x < width; ++x) {
        const float right = ray_x[x] * z[x], down = ray_y * z[x];
        const auto along = [&](int i) { return R(i, 0) * right + R(i, 1) * down + R(i, 2) * z[x] + t[i]; };
        depth[x] = along(2);
        u[x] = fx * along(0) / depth[x] + cx;
        v[x] = fy * along(1) / depth[x] + cy;
    }
}

/// Warps `from` into the chart through the surface. `shown` is set to 255 where `from` sees the surface;
/// elsewhere the result is `fallback`.
cv::Mat warp(const MatchView& chart, const MatchView& from, const Pose& from_pose, const cv::Mat& fallback,
             cv::Mat& shown) {
    const Eigen::Matrix3d R = from_pose.R * chart.pose.R.transpose();
    const Reprojection reprojection{R.cast<float>(),  (from_pose.t - R * chart.pose.t).cast<float>(),
                                    float(from.k.fx), float(from.k.fy),
                                    float(from.k.cx), float(from.k.cy)};
    const int width = chart.depth.cols, height = chart.depth.rows;
    cv::Mat map_x(height, width, CV_32F), map_y(height, width, CV_32F);
    shown.create(height, width, CV_8U);
    const auto right = float(from.gray.cols - 1), bottom = float(from.gray.rows - 1);
    std::vector<float> ray_x, depth(static_cast<std::size_t>(width));
    for (int x = 0; x < width; ++x) ray_x.push_back(float((x + 0.5 - chart.k.cx) / chart.k.fx));
    for (int y = 0; y < height; ++y) {
        const auto* z = chart.depth.ptr<float>(y);
        auto *u = map_x.ptr<float>(y), *v = map_y.ptr<float>(y);
        auto* ok = shown.ptr<std::uint8_t>(y);
        reproject_row(reprojection, z, ray_x.data(), float((y + 0.5 - chart.k.cy) / chart.k.fy), width,
                      {u, v, depth.data()});
        for (int x = 0; x < width; ++x) {
            const float there = depth[std::size_t(x)];
            const bool inside =
                std::isfinite(z[x]) && there > 0 && u[x] >= 0 && v[x] >= 0 && u[x] <= right && v[x] <= bottom;
            ok[x] = inside && std::abs(from.depth.at<float>(int(v[x] + 0.5f), int(u[x] + 0.5f)) - there) <=
                                  float(depth_step) * there
                        ? 255
                        : 0;
            if (!ok[x]) u[x] = v[x] = -1;
        }
    }
    cv::Mat out;
    cv::remap(from.gray, out, map_x, map_y, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
    fallback.copyTo(out, ~shown);
    return out;
}

/// Normalized cross-correlation of two patches; 0 if either has no contrast.
double correlation(const cv::Mat& a, const cv::Point2f& at_a, const cv::Mat& b, const cv::Point2f& at_b) {
    cv::Mat p, q;
    cv::getRectSubPix(a, patch, at_a, p, CV_32F);
    cv::getRectSubPix(b, patch, at_b, q, CV_32F);
    using Values = Eigen::Map<const Eigen::ArrayXf>;
    const Eigen::ArrayXd x = Values(p.ptr<float>(), patch.area()).cast<double>(),
                         y = Values(q.ptr<float>(), patch.area()).cast<double>();
    const double mean_x = x.mean(), mean_y = y.mean(), both = ((x - mean_x) * (y - mean_y)).sum(),
                 of_x = (x - mean_x).square().sum(), of_y = (y - mean_y).square().sum();
    return of_x > 0 && of_y > 0 ? both / std::sqrt(of_x * of_y) : 0;
}

}  // namespace

SurfaceChart::SurfaceChart(const MatchView& view, const Pose& pose, std::uint32_t photo, int corners)
    : view_(view), pose_(pose) {
    cv::Mat shown;
    if (pose.R == view.pose.R && pose.t == view.pose.t) {
        gray_ = view.gray;
        cv::compare(view.depth, std::numeric_limits<float>::infinity(), shown, cv::CMP_LT);
    } else {
        gray_ = warp(view, view, pose, view.gray, shown);
    }
    cv::buildOpticalFlowPyramid(gray_, pyramid_, window, levels);
    std::vector<cv::Point2f> found;
    cv::goodFeaturesToTrack(gray_, found, corners, 0.01, block, shown, 5);
    for (const cv::Point2f& c : found) {
        if (!is_smooth(to_vector(c))) continue;
        const Vector3d x = surface_point(to_vector(c)), right = surface_point(to_vector(c) + Vector2d(2, 0)),
                       down = surface_point(to_vector(c) + Vector2d(0, 2));
        const Vector3d normal = (right - x).cross(down - x).stableNormalized();
        const auto seen = project(view.k, pose, x);
        if (!(normal.squaredNorm() > 0.5) || !seen) continue;
        corners_.push_back(c);
        tracks_.push_back({photo, at_full_size(seen->pixel, view.level), x, normal, {}});
    }
}

bool SurfaceChart::is_smooth(const Vector2d& at) const {
    constexpr int reach = 7;
    const int x = int(std::lround(at.x())), y = int(std::lround(at.y()));
    if (x < reach || y < reach || x + reach >= view_.depth.cols || y + reach >= view_.depth.rows)
        return false;
    const float middle = view_.depth.at<float>(y, x);
    for (int j = -reach; j <= reach; j += reach)
        for (int i = -reach; i <= reach; i += reach)
            if (!(std::abs(view_.depth.at<float>(y + j, x + i) - middle) <= float(depth_step) * middle))
                return false;
    return true;
}

// In OpenCV, pixel centers are at integers.
Vector3d SurfaceChart::surface_point(const Vector2d& at) const {
    const int x = std::clamp(int(std::floor(at.x())), 0, view_.depth.cols - 2),
              y = std::clamp(int(std::floor(at.y())), 0, view_.depth.rows - 2);
    const double fx = at.x() - x, fy = at.y() - y;
    const auto inverse = [&](int i, int j) { return 1 / double(view_.depth.at<float>(y + j, x + i)); };
    // On a plane, inverse depth is linear in image coordinates.
    const double z = 1 / ((1 - fy) * ((1 - fx) * inverse(0, 0) + fx * inverse(1, 0)) +
                          fy * ((1 - fx) * inverse(0, 1) + fx * inverse(1, 1)));
    const Vector3d in_camera((at.x() + 0.5 - view_.k.cx) / view_.k.fx * z,
                             (at.y() + 0.5 - view_.k.cy) / view_.k.fy * z, z);
    return view_.pose.R.transpose() * (in_camera - view_.pose.t);
}

std::size_t SurfaceChart::match(const MatchView& other, const Pose& other_pose, std::uint32_t other_photo) {
    if (corners_.empty()) return 0;
    cv::Mat shown;
    const cv::Mat warped = warp(view_, other, other_pose, gray_, shown);
    std::vector<std::size_t> which;
    std::vector<cv::Point2f> from, to, back;
    for (std::size_t c = 0; c < corners_.size(); ++c) {
        if (!shown.at<std::uint8_t>(int(std::lround(corners_[c].y)), int(std::lround(corners_[c].x))))
            continue;
        which.push_back(c);
        from.push_back(corners_[c]);
    }
    if (from.empty()) return 0;
    std::vector<std::uint8_t> found, found_back;
    cv::Mat error;
    std::vector<cv::Mat> pyramid;
    cv::buildOpticalFlowPyramid(warped, pyramid, window, levels);
    const cv::TermCriteria until(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 20, 0.01);
    cv::calcOpticalFlowPyrLK(pyramid_, pyramid, from, to, found, error, window, levels, until);
    cv::calcOpticalFlowPyrLK(pyramid, pyramid_, to, back, found_back, error, window, levels, until);
    for (std::size_t i = 0; i < from.size(); ++i) {
        if (!found[i] || !found_back[i] || !is_smooth(to_vector(to[i])) ||
            !(cv::norm(back[i] - from[i]) <= max_round_trip) ||
            !shown.at<std::uint8_t>(int(std::lround(to[i].y)), int(std::lround(to[i].x))) ||
            !(correlation(gray_, from[i], warped, to[i]) >= min_correlation))
            continue;
        const auto seen = project(other.k, other_pose, surface_point(to_vector(to[i])));
        if (!seen) continue;
        tracks_[which[i]].matches.push_back({other_photo, at_full_size(seen->pixel, other.level),
                                             at_full_size(to_vector(to[i] - from[i]), view_.level)});
    }
    return from.size();
}

}  // namespace vantage
