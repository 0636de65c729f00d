#pragma once
#include <vector>

#include "player/view/frame_size.h"
#include "player/view/view.h"

namespace vantage {

/// Layout of the two eyes' pictures. Values as in shaders/contract.glsl.
enum class StereoMode { off, side_by_side, over_under, anaglyph, checkerboard, count };

/// The eye separation and the depth of zero parallax, in scene units. Points nearer than that depth appear in
/// front of the screen.
struct Eyes {
    double distance = 0;      ///< eye separation; 0: `share` times the depth of convergence
    double share = 1.0 / 30;  ///< comfortable fraction (Mendiburu 2009)
    double convergence = 0;   ///< 0: depends on the view
    bool operator==(const Eyes&) const = default;
};
struct StereoSettings {
    StereoMode mode = StereoMode::off;
    Eyes eyes;
    bool operator==(const StereoSettings&) const = default;
};

/// The size of each eye's picture in a frame, at least one pixel. Half of an odd number of pixels is rounded
/// down.
FrameSize eye_size(StereoMode mode, FrameSize frame);
/// The frame's size for two pictures of this size.
FrameSize stereo_size(StereoMode mode, FrameSize eye);
/// Whether each eye's picture has a separate part of the frame.
inline bool divides_frame(StereoMode mode) {
    return mode == StereoMode::side_by_side || mode == StereoMode::over_under;
}

/// The eye separation in scene units. `looked_at`: the depth at which the eyes converge, unless `eyes` sets
/// that depth. Throws Error(usage) unless the separation is positive and finite.
double eye_distance(const Eyes& eyes, double looked_at);

/// The views of the left and the right eye, on either side of `middle`. They are parallel, with sheared
/// frusta that coincide at the convergence (Woods, Docherty and Koch 1993), since converging axes would cause
/// vertical parallax. `looked_at`: the depth at which the eyes converge, unless `eyes` sets that depth.
/// Throws Error(usage) if a number is not finite or not positive, or if the view is orthographic.
std::vector<View> eye_views(const View& middle, const Eyes& eyes, double looked_at);
/// Both eyes' views (see eye_views()), or `middle` alone if the mode is off.
std::vector<View> views_of(const StereoSettings& stereo, const View& middle, double looked_at);

}  // namespace vantage
