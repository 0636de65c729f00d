#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

#include "pipeline/background/coarse_view.h"

namespace vantage {

/// A photo's sample at a point on the background.
struct ViewSample {
    enum Kind {
        nothing,   ///< outside the photo, or behind the camera
        behind,    ///< the mesh hides the point
        in_front,  ///< the point would hide the mesh
        open       ///< no mesh: `ln` is the photo's color
    } kind = nothing;
    Eigen::Array3f ln = Eigen::Array3f::Zero();
    Eigen::Vector2f pixel = Eigen::Vector2f::Zero();  ///< if `open`
};

/// The texel that contains a sample.
inline std::size_t texel_of(const CoarseView& v, const ViewSample& s) {
    return std::size_t(s.pixel.y()) * std::size_t(v.k.width) + std::size_t(s.pixel.x());
}

/// The sample at a point. `p` is the point in camera space times `inverse`, and `inverse` may be 0 for a
/// point at infinity.
inline ViewSample sample(const CoarseView& v, const Eigen::Vector3f& p, float inverse) {
    if (!(p.z() > 0)) return {};
    const float x = float(v.k.fx) * p.x() / p.z() + float(v.k.cx) - 0.5f,
                y = float(v.k.fy) * p.y() / p.z() + float(v.k.cy) - 0.5f;
    if (!(x >= 0 && y >= 0 && x < float(v.k.width - 1) && y < float(v.k.height - 1))) return {};
    const auto width = std::size_t(v.k.width), i = std::size_t(x), j = std::size_t(y), at = j * width + i;
    const float u = x - float(i), w = y - float(j);
    const std::size_t nearest = at + (u > 0.5f) + (w > 0.5f ? width : 0);
    if (std::isfinite(v.z[nearest]))
        return {v.z[nearest] * inverse > 1.02f * p.z() ? ViewSample::in_front : ViewSample::behind};
    const Eigen::Array3f ln = (1 - w) * ((1 - u) * v.ln[at] + u * v.ln[at + 1]) +
                              w * ((1 - u) * v.ln[at + width] + u * v.ln[at + width + 1]);
    if (std::isnan(ln[0])) return {};  // one of the four texels is not open
    return {ViewSample::open, ln, {x + 0.5f, y + 0.5f}};
}

/// Median per channel; for an even number of colors, the mean of the two middle values. `colors` must not be
/// empty.
inline Eigen::Array3f median(const std::vector<Eigen::Array3f>& colors) {
    thread_local std::vector<float> channel;
    Eigen::Array3f out;
    for (int c = 0; c < 3; ++c) {
        channel.clear();
        for (const auto& color : colors) channel.push_back(color[c]);
        const auto middle = channel.begin() + std::ptrdiff_t(channel.size() / 2);
        std::nth_element(channel.begin(), middle, channel.end());
        out[c] = *middle;
        if (channel.size() % 2 == 0) out[c] = (out[c] + *std::max_element(channel.begin(), middle)) / 2;
    }
    return out;
}

}  // namespace vantage
