#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "scene/camera/camera.h"
#include "scene/package/package_format.h"

namespace vantage {

/// A subset of the model's triangles, in the model's order.
struct FrameTriangles {
    struct Source {
        std::uint32_t triangle, cluster;  ///< indices in the model
    };
    std::vector<std::uint32_t> indices;  ///< three per triangle
    std::vector<Source> sources;         ///< one per triangle
};

/// The triangles of all clusters whose bounding spheres intersect the camera's view frustum. Conservative: no
/// triangle that projects into the frame is missing.
FrameTriangles triangles_in_frame(std::span<const package::ClusterRecord> clusters,
                                  std::span<const std::uint32_t> indices, const Intrinsics& intrinsics,
                                  const Pose& cam_from_origin);

}  // namespace vantage
