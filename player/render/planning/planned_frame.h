#pragma once
#include <deque>
#include <vector>

#include "player/render/frame_request.h"
#include "player/render/passes/triangle_readback.h"
#include "player/render/planning/image_set_plans.h"

namespace vantage {

/// The plan of an eye, and its last visible triangles.
struct PlannedEye {
    explicit PlannedEye(const PlanScene& scene) : plans(scene) {}
    View view{};
    View sampled{};              ///< a view whose pixel centers are the samples' positions
    bool surface_drawn = false;  ///< `sampled` has been drawn to plan the frame
    ImageSetPlans plans;
    std::vector<ImageSetFrame> image_sets{};
    TriangleReadback readback{};
};

/// The last planned frame.
struct PlannedFrame {
    std::deque<PlannedEye> eyes;  ///< one or two
    PixelSample sample{};
    double now = 0;  ///< seconds

    /// The plan for the first eye and the first shown image set.
    const ViewPlan& first_plan() const { return eyes.front().plans.first(); }
    const Plan& plan() const { return first_plan().plan(); }
};

}  // namespace vantage
