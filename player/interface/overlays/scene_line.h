#pragma once
#include <imgui.h>

#include <Eigen/Core>

#include "player/view/view.h"

namespace vantage {

/// Draws a line over the picture, between two points relative to the origin, clipped to the part in front of
/// the viewer. `width` is in pixels.
void scene_line(ImDrawList& list, const View& view, Eigen::Vector3d a, Eigen::Vector3d b, ImU32 color,
                float width);

}  // namespace vantage
