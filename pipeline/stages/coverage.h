#pragma once
#include <cstdint>
#include <vector>

#include "pipeline/mesh/clusters.h"
#include "pipeline/visibility/frame_triangles.h"
#include "pipeline/visibility/photo_geometry.h"
#include "scene/camera/camera.h"
#include "scene/package/package_format.h"

namespace vantage {

/// What a photo sees of the model, per cluster and per triangle.
struct Coverage {
    std::vector<package::CoverageRecord> clusters;
    std::vector<std::uint64_t> visible;  ///< as VISB: triangles seen whole (all vertices), then in part
};

/// From the photo's triangle map and the vertices' texture coordinates, see vertex_coordinates. `sources`:
/// the model's triangle and cluster of each triangle in the map.
Coverage measure_coverage(const std::vector<package::ClusterRecord>& clusters,
                          const std::vector<std::uint32_t>& indices,
                          const std::vector<FrameTriangles::Source>& sources, const PhotoGeometry& geometry,
                          const std::vector<Eigen::Vector2f>& coordinates, const Intrinsics& intrinsics,
                          const Pose& cam_from_origin);

}  // namespace vantage
