#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/background/coarse_view.h"
#include "pipeline/background/depth/depth_sweep.h"
#include "pipeline/background/direction_sphere.h"
#include "pipeline/background/view_sample.h"

namespace vantage {

/// Sine of the elevation above which what fewer than two photos show is sky.
inline constexpr float lowest_alone = 0.1f;

/// Where photos show sky.
struct Sky {
    Eigen::Vector3f down = Eigen::Vector3f::UnitZ();  ///< unit length
    std::vector<std::vector<std::uint8_t>> masks;     ///< per view and texel; empty if the scene has no sky

    bool any() const { return !masks.empty(); }
    /// Whether view `i`, `v`, shows sky at an open sample.
    bool at(std::size_t i, const CoarseView& v, const ViewSample& s) const {
        return any() && masks[i][texel_of(v, s)];
    }
};

/// Smooth, bright texels above the horizon, connected to parts of the backdrop that are far away. There is no
/// sky unless it is most of what photos show openly up there, see docs/method.md. `inverse`: distances of the
/// sphere's directions.
Sky find_sky(std::span<const CoarseView> views, const SweptDepths& depths, const DirectionSphere& sphere,
             const std::vector<float>& inverse, const Eigen::Vector3d& down);

/// Per direction 1 if it is infinitely far: at least half of the photos that show it show sky, or it is above
/// the horizon, fewer than two photos show it, and it is well above or the mesh hides it from most photos. All 0 in a scene without sky.
std::vector<std::uint8_t> sky_directions(std::span<const CoarseView> views, const Sky& sky,
                                         const DirectionSphere& sphere, unsigned threads);

}  // namespace vantage
