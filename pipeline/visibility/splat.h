#pragma once
#include "pipeline/mesh/splat_cloud.h"
#include "pipeline/visibility/photo_geometry.h"

namespace vantage {

/// Replaces the depth in a stand-in's maps with that of the cloud. Each point is as large as the gaps to its
/// neighbors; the nearest point wins, and single-texel holes in a surface are closed. The angle is 255 at
/// every point, because points face every camera. Triangles are kept where they are at most `slack` (scene
/// units) behind the points. `photo` and `cam_from_origin` are as in render_geometry.
void splat(const SplatCloud& cloud, const Intrinsics& photo, const Pose& cam_from_origin, double slack,
           PhotoGeometry& maps);

}  // namespace vantage
