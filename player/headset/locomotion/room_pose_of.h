#pragma once
#include "player/headset/locomotion/room_pose.h"
#include "player/headset/runtime/openxr.h"

namespace vantage {

inline RoomPose room_pose_of(const XrPosef& p) {
    const auto& [x, y, z, w] = p.orientation;
    return {Eigen::Quaterniond(double(w), double(x), double(y), double(z)).normalized(),
            {double(p.position.x), double(p.position.y), double(p.position.z)}};
}

}  // namespace vantage
