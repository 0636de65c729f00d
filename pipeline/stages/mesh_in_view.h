#pragma once
#include "pipeline/input/scene_input.h"

namespace vantage {

/// A photo sees the mesh if what it shows of the mesh spans at least this share of its frame.
inline constexpr double least_share_of_frame = 0.001;

/// Throws Error(misplaced) with the bounding boxes of mesh and cameras if more than half of the photos do not
/// see the mesh: it has another scale or place than the cameras, or its own frame. Occlusion is ignored.
void expect_mesh_in_view(const SceneInput& scene);

}  // namespace vantage
