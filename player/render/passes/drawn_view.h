#pragma once
#include <Eigen/Core>
#include <vector>

#include "player/plan/views/view_plan.h"
#include "player/render/render_settings.h"

namespace vantage {

struct ImageSetFrame;
struct FrameResources;

/// Data common to all passes of a frame.
struct DrawnView {
    const View& view;
    const RenderSettings& settings;
    const ViewPlan& plan;
    int side;                     ///< samples per side of a pixel
    Eigen::Vector2d depth_range;  ///< nearest and farthest, scene units
    Eigen::Matrix4f clip_from_origin;
    std::vector<double> weights;  ///< dynamic, per photo; empty if all are 1 or the blend mode ignores them
    bool coarse;                  ///< the coarse mesh replaces the mesh
};

/// An image set's frame from `view`, with `side` * `side` samples per pixel. Valid as long as its view and
/// image set exist.
DrawnView drawn_view(const FrameResources& resources, const View& view, const ImageSetFrame& image_set,
                     int side, bool coarse);

/// Whether the coarse mesh is fine enough for a planned view.
bool suits_coarse(const FrameResources& resources, const View& view, const ImageSetFrame& image_set);

/// The coefficients a and b of the frame's depth values, a + b / z. Not for orthographic views.
Eigen::Vector2d depth_terms(const View& view, const Eigen::Vector2d& depth_range);

}  // namespace vantage
