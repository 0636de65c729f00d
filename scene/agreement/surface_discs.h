#pragma once
#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "scene/package/package_format.h"

namespace vantage {

/// A small disc on the model's surface. Photos are compared within such discs.
struct SurfaceDisc {
    Eigen::Vector3f center, normal;  ///< the normal's sign is arbitrary; 0 on a degenerate triangle
    float radius;
};

/// Discs spread over the model, half of them in proportion to area and half in proportion to triangle count,
/// so that neither a large ground plane nor a densely meshed object receives all of them. Deterministic.
/// The radius of a disc is 48 px at `density` (pixels per unit in the finest photo). Triangles with strays
/// count as having no area (see has_stray). `bounds`: relative to the origin. Empty if the model has no
/// triangles.
std::vector<SurfaceDisc> surface_disc_set(std::span<const Eigen::Vector3f> positions,
                                          std::span<const std::uint32_t> indices, double density,
                                          const Eigen::AlignedBox3d& bounds = {});

/// Keeps every `step`-th disc.
std::vector<SurfaceDisc> thinned(std::span<const SurfaceDisc> discs, std::size_t step);

}  // namespace vantage
