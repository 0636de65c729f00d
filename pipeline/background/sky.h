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

/// Sine of the elevation above which directions with fewer than two photos count as sky.
inline constexpr float lowest_alone = 0.1f;

/// The sky in the photos.
struct Sky {
    Eigen::Vector3f down = Eigen::Vector3f::UnitZ();  ///< unit length
    std::vector<std::vector<std::uint8_t>> masks;     ///< per view and texel; empty if the scene has no sky

    bool any() const { return !masks.empty(); }
    /// Whether view `v`, with index `i`, shows sky at an open sample.
    bool at(std::size_t i, const CoarseView& v, const ViewSample& s) const {
        return any() && masks[i][texel_of(v, s)];
    }
};

/// Finds smooth, bright texels above the horizon that are connected to distant parts of the backdrop. Finds
/// no sky unless these texels are a large fraction of the open texels above the horizon; see docs/method.md.
/// `inverse` contains the inverse distances of the sphere's directions.
Sky find_sky(std::span<const CoarseView> views, const SweptDepths& depths, const DirectionSphere& sphere,
             const std::vector<float>& inverse, const Eigen::Vector3d& down);

/// For each direction, 1 if it is at infinity. This is the case if at least half of the photos that cover it
/// show sky there, or if it is above the horizon, is covered by fewer than two photos, and is either high or
/// hidden by the mesh in most photos. All values are 0 in a scene without sky.
std::vector<std::uint8_t> sky_directions(std::span<const CoarseView> views, const Sky& sky,
                                         const DirectionSphere& sphere, unsigned threads);

}  // namespace vantage
