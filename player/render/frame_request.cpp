#include "player/render/frame_request.h"

#include <cmath>
#include <string>

#include "base/text/error.h"

namespace vantage {

std::vector<PixelSample> single_samples(int side) {
    std::vector<PixelSample> out;
    for (int i = 0; i < side * side; ++i) out.push_back({i, side});
    return out;
}

void check_view(const View& view) {
    const Intrinsics& k = view.intrinsics;
    const Pose& pose = view.cam_from_origin;
    const bool turns = (pose.R * pose.R.transpose()).isIdentity(1e-3);
    const bool stands = pose.t.norm() < 1e18;
    const bool lens = k.fx > 0 && k.fy > 0 && std::isfinite(float(k.fx) + float(k.fy)) &&
                      std::isfinite(float(k.cx) + float(k.cy));
    if (k.width < 1 || k.height < 1)
        throw Error(Exit::usage, "a picture of " + std::to_string(k.width) + "x" + std::to_string(k.height) +
                                     ", expected at least 1x1");
    if (!turns || !stands || !lens)
        throw Error(Exit::usage, "a view's position, direction or field of view is not finite");
}

}  // namespace vantage
