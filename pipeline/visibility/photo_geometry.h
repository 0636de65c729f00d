#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "scene/camera/camera.h"

namespace vantage {

/// Maps of the model as seen by a photo's camera, row by row.
struct PhotoGeometry {
    int width = 0, height = 0;             ///< size of the photo at `weight_map_level`
    std::vector<float> z;                  ///< linear depth, +inf if nothing is seen
    std::vector<std::uint8_t> angle;       ///< max(0, n.v), unorm8
    std::vector<std::uint32_t> triangles;  ///< index of the triangle drawn, 2^32 - 1 for none
};

/// The intrinsics of a photo's maps.
Intrinsics map_intrinsics(const Intrinsics& photo);

/// Near and far planes that enclose all vertices; `reach` is that of clip_range.
Eigen::Vector2d depth_range(std::span<const Eigen::Vector3f> positions, const Pose& cam_from_origin,
                            double reach = std::numeric_limits<double>::infinity());

/// Maps of a photo that does not see the model.
PhotoGeometry empty_geometry(const Intrinsics& photo);

}  // namespace vantage
