#include "player/render/pace.h"

#include <algorithm>
#include <cmath>

namespace vantage {

Pace next_pace(Pace pace, double ms, double goal_ms) {
    constexpr double aim = 0.85;      // of the goal: frames of a motion differ
    constexpr double swift_at = 0.6;  // fewer photos, before a frame gets coarser than this
    constexpr double spare = 3;       // what all photos cost at most, compared with a swift frame
    if (!(ms > 0) || !(goal_ms > 0) || !std::isfinite(ms)) return pace;
    // A frame's time does not fall as much as its pixels do: what is left is for the frames to come.
    const double pixels = std::min(aim * goal_ms / ms, 1.2);
    pace.scale = std::clamp(pace.scale * std::sqrt(pixels), least_scale, 1.0);
    if (pace.scale < swift_at) pace.swift = true;
    if (pace.scale == 1 && spare * ms < goal_ms) pace.swift = false;
    return pace;
}

Pace first_pace(double ms, double goal_ms) {
    constexpr double caution = 0.6;
    Pace pace = next_pace({}, ms, goal_ms);
    if (pace.scale < 1) pace.scale = std::max(caution * pace.scale, least_scale);
    return pace;
}

View scaled(const View& view, double share) {
    const auto size = [&](int pixels) { return std::max(1, int(std::lround(pixels * share))); };
    View out = view;
    out.intrinsics = view.intrinsics.scaled(size(view.intrinsics.width), size(view.intrinsics.height));
    return out;
}

}  // namespace vantage
