#pragma once
#include <cstdint>
#include <vector>

#include "scene/camera.h"
#include "scene/package_format.h"

namespace vantage {

/// Some of the model's triangles, in order.
struct FrameTriangles {
    struct Place {
        std::uint32_t triangle, cluster;  ///< in the model
    };
    std::vector<std::uint32_t> indices;  ///< three a triangle
    std::vector<Place> places;           ///< one a triangle
};

/// The triangles of all clusters that may reach into a camera's frame. Never drops one that does.
FrameTriangles triangles_in_frame(const std::vector<package::ClusterRecord>& clusters,
                                  const std::vector<std::uint32_t>& indices, const Intrinsics& intrinsics,
                                  const Pose& cam_from_origin);

}  // namespace vantage
