#include "player/stream/photo_block.h"

#include <algorithm>
#include <cmath>

#include "scene/package/package_reader.h"

namespace vantage {

PhotoBlock make_photo_block(const package::PhotoRecord& p, std::uint32_t index, std::uint8_t label) {
    PhotoBlock b{};
    const Pose pose = cam_from_origin(p);
    const Eigen::Vector3d center = pose.center();
    Eigen::Map<Eigen::Matrix4f> m(b.cam_from_origin);
    m.setIdentity();
    m.topLeftCorner<3, 3>() = pose.R.cast<float>();
    m.topRightCorner<3, 1>() = pose.t.cast<float>();
    const double intrinsics[] = {p.fx, p.fy, p.cx, p.cy};
    for (int i = 0; i < 4; ++i) b.focal_center[i] = float(intrinsics[i]);
    b.size_weight[0] = float(p.width);
    b.size_weight[1] = float(p.height);
    b.size_weight[2] = float(p.levels);
    b.size_weight[3] = 1;
    for (int i = 0; i < 3; ++i) {
        b.center_hull[i] = float(center[i]);
        b.direction[i] = float(p.corrected_direction[i]);
    }
    b.center_hull[3] = float(p.hull_area);
    b.direction[3] = -1;
    const FalseColor c = false_color(index);
    const float linear[] = {std::pow(c.r, 2.2f), std::pow(c.g, 2.2f), std::pow(c.b, 2.2f)};
    for (int i = 0; i < 3; ++i) {
        b.false_color[i] = linear[i];
        b.gain[i] = float(p.gain[i]);
        b.vignetting[i] = p.vignetting[i];
    }
    b.false_color[3] = float(label);
    b.gain[3] = float(2 / std::hypot(p.width, p.height));
    return b;
}

FalseColor false_color(std::uint32_t index) {
    // Hues separated by the golden ratio, so that consecutive photos differ the most.
    const float hue = std::fmod(float(index) * 0.61803399f + 0.05f, 1.0f) * 6,
                value = index % 2 ? 0.95f : 0.75f;
    const auto channel = [&](float offset) {
        const float k = std::fmod(hue + offset, 6.0f);
        return value * (1 - 0.65f * std::max(0.0f, std::min({k, 4 - k, 1.0f})));
    };
    return {channel(5), channel(3), channel(1)};
}

}  // namespace vantage
