#pragma once
#include <vector>

#include "player/view/frame_size.h"
#include "player/view/view.h"

namespace vantage {

/// How the pictures of two eyes make one. Values as in shaders/contract.glsl.
enum class StereoMode { off, side_by_side, over_under, anaglyph, checkerboard, count };

/// How far the eyes are apart, and the depth at which their pictures agree, in scene units: what is nearer
/// appears in front of the screen.
struct Eyes {
    double distance = 0;      ///< 0: `share` of the convergence
    double share = 1.0 / 30;  ///< comfortable (Mendiburu 2009)
    double convergence = 0;   ///< 0: chosen from the view
    bool operator==(const Eyes&) const = default;
};
struct StereoSettings {
    StereoMode mode = StereoMode::off;
    Eyes eyes;
    bool operator==(const StereoSettings&) const = default;
};

/// The size of each eye's picture in a frame, at least one pixel. The halves of an odd number of pixels are
/// as large as fits twice.
FrameSize eye_size(StereoMode mode, FrameSize frame);
/// The size of the frame that two pictures of this size make.
FrameSize stereo_size(StereoMode mode, FrameSize eye);
/// Each eye's picture has a part of the frame for itself.
inline bool divides_frame(StereoMode mode) {
    return mode == StereoMode::side_by_side || mode == StereoMode::over_under;
}

/// In scene units. `looked_at`: the depth at which the eyes converge unless `eyes` says so. Throws
/// Error(usage) if it is not finite and above 0.
double eye_distance(const Eyes& eyes, double looked_at);

/// The views of the left and of the right eye, to both sides of `middle`: parallel, with frusta that are
/// sheared so that they meet at the convergence (Woods, Docherty and Koch 1993); turned toward each other,
/// the eyes would see heights that differ. `looked_at`: the depth at which they converge unless `eyes` says
/// so. Throws Error(usage) for numbers that are not finite, or not positive, and for an orthographic view.
std::vector<View> eye_views(const View& middle, const Eyes& eyes, double looked_at);
/// The same, or `middle` alone if the mode is off.
std::vector<View> views_of(const StereoSettings& stereo, const View& middle, double looked_at);

}  // namespace vantage
