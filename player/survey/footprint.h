#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "player/plan/plan_scene.h"

namespace vantage {

/// The size of a photo's pixel on a plane through a point, parallel to the photo's image plane.
struct Footprint {
    double size;          ///< depth over focal length, in units of the package's mesh
    std::uint32_t photo;  ///< index of the photo
};

/// Footprints of the photos that see a point on a triangle (numbered from 0), smallest first. A photo sees
/// the point if its coverage includes the triangle, its frame contains the point, and no other surface of the
/// mesh lies between its camera and the point.
std::vector<Footprint> footprints(const PlanScene& scene, std::uint32_t triangle,
                                  const Eigen::Vector3d& position);
/// The smallest of these footprints; nullopt if no photo sees the point.
std::optional<Footprint> smallest_footprint(const PlanScene& scene, std::uint32_t triangle,
                                            const Eigen::Vector3d& position);

}  // namespace vantage
