#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/background/coarse_view.h"
#include "pipeline/background/depth/planes.h"
#include "pipeline/background/direction_sphere.h"
#include "pipeline/background/sky.h"

namespace vantage {

/// Resolution of the background estimate.
struct BackdropDetail {
    int sphere = 5;       ///< level of the direction sphere
    int labels = 96;      ///< depths per direction
    int refinements = 2;  ///< number of further subdivisions, for sharper edges
    bool sky = true;      ///< whether sky is distinguished from other distant background
};
/// Enough to validate the effect; too coarse for the outline of the sky.
inline constexpr BackdropDetail validated_detail{.sphere = 4, .labels = 32, .refinements = 0, .sky = false};

/// A closed surface around the cameras, star-shaped about their center: one vertex per direction.
struct Backdrop {
    DirectionSphere sphere;
    Eigen::Vector3d center;                  ///< relative to the origin
    std::vector<Eigen::Vector3f> positions;  ///< relative to the origin, all finite
    Sky sky;
    std::vector<std::uint8_t> is_sky;  ///< per direction; see sky_directions()
};

/// Estimates the background's depth by direction from the photos; see docs/method.md. Needs at least two
/// views with different centers.
Backdrop estimate_backdrop(std::span<const CoarseView> views, const MeshPlanes& mesh,
                           const BackdropDetail& detail, unsigned threads);

/// Whether the centers of the views differ, as estimate_backdrop() requires.
bool have_parallax(std::span<const CoarseView> views);

}  // namespace vantage
