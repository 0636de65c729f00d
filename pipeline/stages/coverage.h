#pragma once
#include <cstdint>
#include <vector>

#include "pipeline/model/clusters.h"
#include "pipeline/visibility/frame_triangles.h"
#include "pipeline/visibility/photo_geometry.h"
#include "scene/camera.h"
#include "scene/package_format.h"

namespace vantage {

/// What a photo sees of the model: by cluster, and by triangle.
struct Coverage {
    std::vector<package::CoverageRecord> clusters;
    std::vector<std::uint64_t> visible;  ///< as VISB: seen whole (all vertices), then seen in part
};

/// From the triangles under the pixels of the photo's triangle map (`places` tells which those are) and the
/// vertices' texture coordinates.
Coverage measure_coverage(const std::vector<package::ClusterRecord>& clusters,
                          const std::vector<std::uint32_t>& indices,
                          const std::vector<FrameTriangles::Place>& places, const PhotoGeometry& geometry,
                          const std::vector<Eigen::Vector2f>& coordinates, const Intrinsics& intrinsics,
                          const Pose& cam_from_origin);

}  // namespace vantage
