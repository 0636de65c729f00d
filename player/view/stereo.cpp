#include "player/view/stereo.h"

#include <algorithm>
#include <cmath>

#include "base/text/error.h"

namespace vantage {
namespace {

double convergence_of(const Eyes& eyes, double looked_at) {
    return eyes.convergence > 0 ? eyes.convergence : looked_at;
}

}  // namespace

FrameSize eye_size(StereoMode mode, FrameSize frame) {
    if (mode == StereoMode::side_by_side) frame.width = std::max(1, frame.width / 2);
    if (mode == StereoMode::over_under) frame.height = std::max(1, frame.height / 2);
    return frame;
}

FrameSize stereo_size(StereoMode mode, FrameSize eye) {
    if (mode == StereoMode::side_by_side) eye.width *= 2;
    if (mode == StereoMode::over_under) eye.height *= 2;
    return eye;
}

double eye_distance(const Eyes& eyes, double looked_at) {
    const double distance = eyes.distance > 0 ? eyes.distance : eyes.share * convergence_of(eyes, looked_at);
    if (!(distance > 0) || !std::isfinite(distance))
        throw Error(Exit::usage, "--stereo: the eyes' distance must be finite and above 0");
    return distance;
}

std::vector<View> eye_views(const View& middle, const Eyes& eyes, double looked_at) {
    const double convergence = convergence_of(eyes, looked_at), distance = eye_distance(eyes, looked_at);
    const double shear = middle.intrinsics.fx * distance / convergence;  // pixels
    if (!(convergence > 0) || !std::isfinite(shear))
        throw Error(Exit::usage, "--stereo: the eyes' distance and convergence must be finite and above 0");
    if (middle.orthographic_depth > 0)
        throw Error(Exit::usage, "--stereo: an orthographic view is the same for both eyes");
    View left = middle, right = middle;
    left.cam_from_origin.t.x() += distance / 2;
    right.cam_from_origin.t.x() -= distance / 2;
    left.intrinsics.cx -= shear / 2;
    right.intrinsics.cx += shear / 2;
    return {left, right};
}

std::vector<View> views_of(const StereoSettings& stereo, const View& middle, double looked_at) {
    if (stereo.mode == StereoMode::off) return {middle};
    return eye_views(middle, stereo.eyes, looked_at);
}

}  // namespace vantage
