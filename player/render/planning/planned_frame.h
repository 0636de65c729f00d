#pragma once
#include <deque>
#include <vector>

#include "player/render/frame_request.h"
#include "player/render/passes/triangle_readback.h"
#include "player/render/planning/image_set_plans.h"

namespace vantage {

/// What is planned for an eye, and the triangles that it saw last.
struct PlannedEye {
    explicit PlannedEye(const PlanScene& scene) : plans(scene) {}
    View view{};
    View sampled{};              ///< its pixel centers are the samples' positions
    bool surface_drawn = false;  ///< `sampled` has been drawn to plan the frame
    ImageSetPlans plans;
    std::vector<ImageSetFrame> image_sets{};
    TriangleReadback readback{};
};

/// The frame that was planned last.
struct PlannedFrame {
    std::deque<PlannedEye> eyes;  ///< one or two
    PixelSample sample{};
    double now = 0;  ///< seconds

    /// Of the first eye, and the first image set that is shown.
    const ViewPlan& first_plan() const { return eyes.front().plans.first(); }
    const Plan& plan() const { return first_plan().plan(); }
};

}  // namespace vantage
