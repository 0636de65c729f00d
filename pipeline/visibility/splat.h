#pragma once
#include "pipeline/mesh/splat_cloud.h"
#include "pipeline/visibility/photo_geometry.h"

namespace vantage {

/// Replaces the depth of a stand-in's maps by that of the cloud, each point as large as gaps to its neighbors
/// are; the nearest wins, and single texels that show what is behind a surface are closed. The angle is 255
/// wherever a point is: points face every camera. The triangles stay where they are at most `slack` (scene
/// units) behind the points. `photo` and `pose` as in render_geometry.
void splat(const SplatCloud& cloud, const Intrinsics& photo, const Pose& cam_from_origin, double slack,
           PhotoGeometry& maps);

}  // namespace vantage
