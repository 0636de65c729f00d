#pragma once
#include "player/plan/plan_scene.h"
#include "player/view/view.h"

namespace vantage::bench {

/// The depth at which two eyes converge: the depth of the scene's center or, if the center is not in front of
/// the viewer, the scene's size.
inline double looked_at(const View& view, const PlanScene& scene) {
    const double depth = depth_in(view, Eigen::Vector3d::Zero());
    return depth > 0 ? depth : scene.size;
}

}  // namespace vantage::bench
