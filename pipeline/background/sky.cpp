#include "pipeline/background/sky.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "base/values/srgb.h"

namespace vantage {
namespace {

constexpr float brightest = 130;     ///< minimum sRGB code of the brightest channel
constexpr float steepest = 14;       ///< maximum difference between neighboring texels, sRGB codes
constexpr float far_away = 20;       ///< distance in units of the cameras' spread
constexpr double far_share = 0.1;    ///< minimum fraction of distant directions in a connected region
constexpr int smallest_part = 30;    ///< texels
constexpr double least_share = 0.3;  ///< minimum fraction of sky in the open texels above the horizon

/// The viewing direction of a texel, not normalized.
Eigen::Vector3f ray_of(const CoarseView& v, int x, int y) {
    const Eigen::Vector3d ray((x + 0.5 - v.k.cx) / v.k.fx, (y + 0.5 - v.k.cy) / v.k.fy, 1);
    return (v.pose.R.transpose() * ray).cast<float>();
}

/// sRGB code of the brightest channel; negative where the view is not open.
cv::Mat1f brightness(const CoarseView& v) {
    cv::Mat1f out(v.k.height, v.k.width, -1.0f);
    for (std::size_t at = 0; at < v.ln.size(); ++at)
        if (v.is_open(at))
            out.ptr<float>()[at] =
                float(255 * srgb_from_linear(std::clamp(double(linear_of(v.ln[at]).maxCoeff()), 0.0, 1.0)));
    return out;
}

/// For each texel: 255 if it is open, lies above the horizon and looks like sky; 1 if it is open and lies
/// above the horizon, but does not look like sky; otherwise 0.
cv::Mat1b candidates(const CoarseView& v, const Eigen::Vector3f& down) {
    const cv::Mat1f light = brightness(v);
    cv::Mat1b out(v.k.height, v.k.width, uchar(0));
    for (int y = 0; y < v.k.height; ++y)
        for (int x = 0; x < v.k.width; ++x) {
            const float here = light(y, x);
            if (here < 0 || ray_of(v, x, y).dot(down) >= 0) continue;
            out(y, x) = 1;
            float steps = 0;
            for (const auto& [i, j] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
                const int a = x + i, b = y + j;
                if (a < 0 || b < 0 || a >= v.k.width || b >= v.k.height || light(b, a) < 0) continue;
                steps = std::max(steps, std::abs(light(b, a) - here));
            }
            if (here > brightest && steps < steepest) out(y, x) = 255;
        }
    return out;
}

/// The number of directions in a connected region of the view, and the number of those that are far away.
struct PartDirections {
    int all = 0, far = 0;
};
std::vector<PartDirections> directions_in(const cv::Mat1i& parts, int count, const CoarseView& v,
                                          const SweptDepths& depths, const DirectionSphere& sphere,
                                          const std::vector<float>& inverse) {
    std::vector<PartDirections> out(static_cast<std::size_t>(count));
    const Eigen::Matrix3f R = v.pose.R.cast<float>();
    for (std::size_t d = 0; d < sphere.directions.size(); ++d) {
        const Eigen::Vector3f p = R * sphere.directions[d];
        if (!(p.z() > 0)) continue;
        const float x = float(v.k.fx) * p.x() / p.z() + float(v.k.cx),
                    y = float(v.k.fy) * p.y() / p.z() + float(v.k.cy);
        if (!(x >= 0 && y >= 0 && x < float(v.k.width) && y < float(v.k.height))) continue;
        PartDirections& part = out[std::size_t(parts(int(y), int(x)))];
        ++part.all;
        part.far += inverse[d] * float(depths.reach) * far_away < 1;
    }
    return out;
}

/// Keeps connected regions that are large and contain distant directions, and dilates them by a texel.
std::vector<std::uint8_t> far_parts(const cv::Mat1b& candidate, const CoarseView& v,
                                    const SweptDepths& depths, const DirectionSphere& sphere,
                                    const std::vector<float>& inverse) {
    cv::Mat1i parts, statistics;
    cv::Mat1d centers;
    const int count = cv::connectedComponentsWithStats(candidate == 255, parts, statistics, centers, 4);
    const auto directions = directions_in(parts, count, v, depths, sphere, inverse);
    cv::Mat1b mask(candidate.size(), uchar(0));
    for (int i = 1; i < count; ++i) {
        const PartDirections& d = directions[std::size_t(i)];
        if (statistics(i, cv::CC_STAT_AREA) >= smallest_part && d.far > far_share * std::max(d.all, 1))
            mask.setTo(1, parts == i);
    }
    cv::dilate(mask, mask, cv::Mat::ones(3, 3, CV_8U));
    mask.setTo(0, candidate == 0);
    return {mask.datastart, mask.dataend};
}

}  // namespace

Sky find_sky(std::span<const CoarseView> views, const SweptDepths& depths, const DirectionSphere& sphere,
             const std::vector<float>& inverse, const Eigen::Vector3d& down) {
    Sky out{down.cast<float>(), {}};
    std::size_t above = 0, sky = 0;
    for (const CoarseView& v : views) {
        const cv::Mat1b candidate = candidates(v, out.down);
        out.masks.push_back(far_parts(candidate, v, depths, sphere, inverse));
        above += std::size_t(cv::countNonZero(candidate));
        sky += std::size_t(std::ranges::count(out.masks.back(), 1));
    }
    if (double(sky) < least_share * double(above) || sky == 0) out.masks.clear();
    return out;
}

std::vector<std::uint8_t> sky_directions(std::span<const CoarseView> views, const Sky& sky,
                                         const DirectionSphere& sphere, unsigned threads) {
    std::vector<std::uint8_t> out(sphere.directions.size(), 0);
    if (!sky.any()) return out;
    for_each_direction(out.size(), threads, [&](std::size_t d) {
        const Eigen::Vector3f& direction = sphere.directions[d];
        if (direction.dot(sky.down) >= 0) return;
        std::size_t inside = 0, shown = 0, as_sky = 0;
        for (std::size_t i = 0; i < views.size(); ++i) {
            const CoarseView& v = views[i];
            const ViewSample s = sample(v, v.pose.R.cast<float>() * direction, 0);
            inside += s.kind != ViewSample::nothing;
            if (s.kind != ViewSample::open) continue;
            ++shown;
            as_sky += sky.at(i, v, s);
        }
        const bool hidden = 2 * inside > views.size(), high = -direction.dot(sky.down) > lowest_alone;
        out[d] = shown < 2 ? hidden || high : 2 * as_sky >= shown;
    });
    return out;
}

}  // namespace vantage
