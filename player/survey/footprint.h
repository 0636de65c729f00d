#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "player/plan/plan_scene.h"

namespace vantage {

/// How large a pixel of a photo is on a plane through a point that faces the photo.
struct Footprint {
    double size;          ///< depth over focal length, in units of the package's mesh
    std::uint32_t photo;  ///< whose pixels are that small
};

/// Those of the photos that see a point of a triangle (from 0), the smallest first: whose coverage has the
/// triangle, in whose frame the point is, and between whose camera and the point the mesh has nothing else.
std::vector<Footprint> footprints(const PlanScene& scene, std::uint32_t triangle,
                                  const Eigen::Vector3d& position);
/// The first of them. Nothing if no photo sees it.
std::optional<Footprint> smallest_footprint(const PlanScene& scene, std::uint32_t triangle,
                                            const Eigen::Vector3d& position);

}  // namespace vantage
