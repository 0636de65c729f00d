#include "player/interface/overlays/scene_line.h"

#include <algorithm>

namespace vantage {

void scene_line(ImDrawList& list, const View& view, Eigen::Vector3d a, Eigen::Vector3d b, ImU32 color,
                float width) {
    const Pose& pose = view.cam_from_origin;
    const Intrinsics& k = view.intrinsics;
    a = pose.R * a + pose.t;
    b = pose.R * b + pose.t;
    const double nearest = 1e-3 * std::max(a.norm(), b.norm());
    if (a.z() < nearest && b.z() < nearest) return;
    if (a.z() < nearest) a += (b - a) * ((nearest - a.z()) / (b.z() - a.z()));
    if (b.z() < nearest) b += (a - b) * ((nearest - b.z()) / (a.z() - b.z()));
    const auto pixel = [&](const Eigen::Vector3d& p) {
        return ImVec2(float(k.fx * p.x() / p.z() + k.cx), float(k.fy * p.y() / p.z() + k.cy));
    };
    list.AddLine(pixel(a), pixel(b), color, width);
}

}  // namespace vantage
