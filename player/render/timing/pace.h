#pragma once
#include "player/view/frame_size.h"
#include "player/view/view.h"

namespace vantage {

/// Quality of frames in motion, adapted to the time limit.
struct Pace {
    double scale = 1;      ///< fraction of the frame's width and height, least_scale to 1
    bool reduced = false;  ///< see RenderSettings::reduced
    bool operator==(const Pace&) const = default;
};
/// Minimum scale of a frame. Coarser frames would hardly be faster, because the time for drawing triangles
/// stays the same.
inline constexpr double least_scale = 0.15;

/// Maximum ratio of the duration of a full frame to that of a reduced frame.
inline constexpr double max_for_all_photos = 3;

/// The pace of the first picture, which consists of base levels.
inline constexpr Pace coarse_pace{0.25, true};

/// The pace of the next frame after a frame at `pace` that took `ms`, if the goal is `goal_ms`. Slows down
/// immediately, and speeds up by at most a fifth of the pixels per frame. Returns `pace` if `ms` or `goal_ms`
/// is not positive, or if `ms` is not finite. `all_photos`: ratio of the duration of a full frame to that of
/// a reduced frame.
Pace next_pace(Pace pace, double ms, double goal_ms, double all_photos = max_for_all_photos);

/// The pace of the next frame, and the state from previous frames.
struct Pacing {
    Pace pace;
    double full_frame_ms = 0;  ///< duration of a full-size frame; 0: unknown
    Pace before{};             ///< pace before a sudden slowdown
    int watched = 0;  ///< remaining frames in which the slowdown may prove temporary; 0: none recently
    double all_photos = max_for_all_photos;  ///< ratio as for next_pace(), estimated from frames
    double last = 0;  ///< duration of a full-size frame in ms, estimated from the last frame; 0: none
    bool last_reduced = false;  ///< the last frame was reduced
};

/// Like next_pace(), but for a series of frames, one of which was drawn at the pace `drawn` and took `ms`;
/// that frame may be a few frames old. Keeps the pace while frames take 0.72 to 0.92 of the goal, so that the
/// resolution does not change in every frame. Evaluates a new pace only from frames drawn at that pace, and
/// returns to the former pace immediately after a temporary slowdown.
Pacing next_pacing(Pacing pacing, Pace drawn, double ms, double goal_ms);

/// The pace at the start of a motion, if a frame at rest takes `ms`. The estimate is conservative, since the
/// part of the time that depends on pixels is unknown.
Pace first_pace(double ms, double goal_ms);

/// A view scaled to a fraction of its width and height.
View scaled(const View& view, double share);

}  // namespace vantage
