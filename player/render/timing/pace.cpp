#include "player/render/timing/pace.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vantage {

Pace next_pace(Pace pace, double ms, double goal_ms, double all_photos) {
    constexpr double aim = 0.82;        // fraction of the goal, since frames vary during a motion
    constexpr double reduced_at = 0.6;  // fewer photos before a frame becomes coarser than this
    constexpr double all_at = 0.7;      // all photos again as soon as frames can be this fine
    if (!(ms > 0) || !(goal_ms > 0) || !std::isfinite(ms)) return pace;
    // Frame time decreases less than proportionally to the number of pixels; later frames make up the
    // difference.
    const double pixels = std::min(aim * goal_ms / ms, 1.2);
    pace.scale = std::clamp(pace.scale * std::sqrt(pixels), least_scale, 1.0);
    if (pace.scale < reduced_at) pace.reduced = true;
    const double with_all = std::sqrt(aim * goal_ms / (all_photos * ms));
    if (pace.reduced && pace.scale == 1 && with_all > all_at) pace = {std::min(with_all, 1.0), false};
    return pace;
}

namespace {

/// Compares a frame with the previous one if exactly one of them was reduced.
void learn(Pacing& p, bool reduced, double whole) {
    constexpr double least = 1.1, margin = 1.1;
    const double last = std::exchange(p.last, whole);
    if (std::exchange(p.last_reduced, reduced) == reduced || !(last > 0)) return;
    const double ratio = reduced ? last / whole : whole / last;
    p.all_photos = std::clamp(margin * ratio, least, max_for_all_photos);
}

}  // namespace

Pacing next_pacing(Pacing p, Pace drawn, double ms, double goal_ms) {
    constexpr double suddenly = 1.5, as_before = 1.2, caution = 0.85;
    // If the slowdown persisted, frames at the new pace would take at least 0.7 of the goal.
    constexpr double passed = 0.63;
    constexpr int watched = 8;
    if (!(ms > 0) || !(goal_ms > 0) || !std::isfinite(ms)) return p;
    const double whole = ms / (drawn.scale * drawn.scale);
    learn(p, drawn.reduced, whole);
    if (p.watched > 0) {
        --p.watched;
        if (drawn == p.before ? whole <= as_before * p.full_frame_ms
                              : drawn == p.pace && ms < passed * goal_ms) {
            p.pace = p.before, p.watched = 0;
            return p;
        }
    } else if (ms > goal_ms && p.full_frame_ms > 0 && whole > suddenly * p.full_frame_ms) {
        // The photos stay the same, because otherwise later frames would not show whether the slowdown has
        // ended.
        p.before = p.pace, p.watched = watched;
        p.pace = {next_pace(drawn, ms, caution * goal_ms).scale, p.pace.reduced};
        return p;
    }
    if (drawn != p.pace) return p;  // from before the last change
    if (p.watched == 0 && ms <= goal_ms) p.full_frame_ms = whole;
    if (ms < 0.72 * goal_ms || ms > 0.92 * goal_ms) p.pace = next_pace(drawn, ms, goal_ms, p.all_photos);
    return p;
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
