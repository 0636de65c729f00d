#include "pipeline/background/depth/place_cost.h"

#include <algorithm>
#include <limits>

#include "pipeline/background/view_sample.h"

namespace vantage {
namespace {

constexpr float shown_once = 0.35f, shown_never = 0.4f;
constexpr float hides = 1.0f;  ///< cost if the point would hide the mesh

/// The cost of a point: the mean difference of its colors from their median.
float disagreement(const std::vector<Eigen::Array3f>& colors) {
    if (colors.empty()) return shown_never;
    if (colors.size() == 1) return shown_once;
    const Eigen::Array3f middle = median(colors);
    float sum = 0;
    for (const auto& color : colors) sum += std::min(PlaceCost::largest, (color - middle).abs().mean());
    return sum / float(colors.size() - 1);
}

/// The half-spaces in front of the camera and inside each side of the photo, as in sample().
Eigen::Matrix<float, 5, 3> frame_of(const Intrinsics& k) {
    const auto fx = float(k.fx), fy = float(k.fy), left = float(k.cx) - 0.5f, top = float(k.cy) - 0.5f;
    Eigen::Matrix<float, 5, 3> out;
    out << 0, 0, 1,                         //
        fx, 0, left,                        //
        -fx, 0, float(k.width - 1) - left,  //
        0, fy, top,                         //
        0, -fy, float(k.height - 1) - top;
    return out;
}

}  // namespace

PlaceCost::PlaceCost(std::span<const CoarseView> views, const Eigen::Vector3d& center) {
    for (const CoarseView& v : views) {
        views_.push_back(
            {v, v.pose.R.cast<float>(), (v.pose.R * center + v.pose.t).cast<float>(), frame_of(v.k)});
        eyes_.push_back((v.pose.center() - center).cast<float>());
    }
}

void PlaceCost::aim(const Eigen::Vector3f& direction, float low, float high, Sights& out) const {
    out.clear();
    for (const SweptView& v : views_) {
        const Eigen::Vector3f ray = v.R * direction;
        // These values are linear in the inverse distance: if one is negative at both ends, it is negative
        // between them.
        const Eigen::Array<float, 5, 1> near_side = v.frame * (v.center * high + ray),
                                        far_side = v.frame * (v.center * low + ray);
        if (!(near_side < 0 && far_side < 0).any()) out.push_back({&v.view, v.center, ray});
    }
}

float PlaceCost::operator()(const Sights& sights, float inverse) const {
    thread_local std::vector<Eigen::Array3f> colors;
    colors.clear();
    bool hiding = false;
    for (const Sight& v : sights) {
        const ViewSample s = sample(*v.view, v.center * inverse + v.ray, inverse);
        hiding |= s.kind == ViewSample::in_front;
        if (s.kind == ViewSample::open) colors.push_back(s.ln);
    }
    return disagreement(colors) + (hiding ? hides : 0);
}

bool PlaceCost::is_shown(const Sights& sights, float inverse) const {
    return std::ranges::any_of(sights, [&](const Sight& v) {
        return sample(*v.view, v.center * inverse + v.ray, inverse).kind != ViewSample::nothing;
    });
}

float PlaceCost::innermost(const Eigen::Vector3f& direction) const {
    float most = std::numeric_limits<float>::infinity();
    for (const Eigen::Vector3f& eye : eyes_) {
        const float distance = eye.norm();
        if (direction.dot(eye) > 0.98f * distance)
            most = std::min(most, 1 / (1.05f * std::max(distance, 1e-30f)));
    }
    return most;
}

}  // namespace vantage
