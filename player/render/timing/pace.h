#pragma once
#include "player/view/frame_size.h"
#include "player/view/view.h"

namespace vantage {

/// How frames in motion are drawn so that they take no longer than they may.
struct Pace {
    double scale = 1;      ///< of the frame's width and height, least_scale to 1
    bool reduced = false;  ///< see RenderSettings::reduced
    bool operator==(const Pace&) const = default;
};
/// Coarser frames would hardly be faster: what remains is the time for the triangles.
inline constexpr double least_scale = 0.15;

/// How many times as long as a reduced frame one takes that is not, at most.
inline constexpr double max_for_all_photos = 3;

/// Of a first picture, which is made of base levels.
inline constexpr Pace coarse_pace{0.25, true};

/// The pace of the next frame, after one at `pace` that took `ms`, of which `goal_ms` are allowed. Slows down
/// at once, and quickens by at most a fifth of the pixels per frame. Without a time or a goal above 0, the
/// same pace. `all_photos`: how many times as long a frame takes that is not reduced.
Pace next_pace(Pace pace, double ms, double goal_ms, double all_photos = max_for_all_photos);

/// The pace of the next frame, and what is known about those before it.
struct Pacing {
    Pace pace;
    double full_frame_ms = 0;  ///< that a frame of full size would take; 0: not known
    Pace before{};             ///< before frames suddenly took longer
    int watched = 0;  ///< frames for which that may prove to have passed; 0: it has not happened recently
    double all_photos = max_for_all_photos;  ///< as for next_pace(), as far as frames have shown
    double last = 0;            ///< ms that a frame of full size would take by the last time; 0: none
    bool last_reduced = false;  ///< that frame
};

/// The same from a series of frames, of which one `drawn` at this pace took `ms`; it may be some frames old.
/// Leaves the pace as it is while frames take .72 to .92 of the goal, so that the picture does not change its
/// resolution in every frame; judges a new pace by its own frames only; and returns to the former pace at
/// once if frames were late for a moment only.
Pacing next_pacing(Pacing pacing, Pace drawn, double ms, double goal_ms);

/// The pace at which a motion begins, if a frame at rest takes `ms`. Cautious: it cannot be known how much of
/// the time is for the frame's pixels.
Pace first_pace(double ms, double goal_ms);

/// A view as it is drawn at a share of its width and height.
View scaled(const View& view, double share);

}  // namespace vantage
