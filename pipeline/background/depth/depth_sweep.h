#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "pipeline/background/coarse_view.h"
#include "pipeline/background/depth/planes.h"
#include "pipeline/background/direction_sphere.h"

namespace vantage {

/// Depths by direction, as inverse distances from a center: the base, which is the ground or infinity, plus a
/// label times `step`.
struct SweptDepths {
    Eigen::Vector3d center = Eigen::Vector3d::Zero();  ///< mean of the cameras, relative to the origin
    /// Root mean square distance of the cameras from the center.
    double reach = 1;
    int labels = 0;
    float step = 0;
    std::vector<float> base;           ///< per direction
    std::vector<float> most;           ///< largest value per direction with no camera behind the backdrop
    std::vector<std::uint32_t> shown;  ///< directions that may be in a photo
    std::vector<float> cost;           ///< disagreement of the photos, per shown direction and label
    std::vector<std::vector<float>> planes;  ///< inverse distance or 0, per plane and shown direction
};

/// Costs that do not come from photos, in units of ln(color).
struct DepthPriors {
    /// Added for the nearest label, and proportionally less for farther ones, to prefer the base.
    static constexpr float nearer = 0.2f;
    static constexpr float not_base = 0.02f;
    static constexpr float inside = 2.0f;       ///< added if a camera is behind the backdrop
    static constexpr float on_a_plane = 0.04f;  ///< subtracted on walls

    static float of_label(float label, int labels) {
        return label > 0.5f ? not_base + nearer * label / float(labels) : 0;
    }
};

/// Sweeps a point along each direction from infinity inward, as in plane sweeping (Collins 1996), and
/// compares the photos that show it.
SweptDepths sweep_depths(std::span<const CoarseView> views, const DirectionSphere& sphere,
                         const ScenePlanes& planes, int labels, unsigned threads);

/// Lowers the cost of depths on these planes.
void prefer_planes(SweptDepths& depths, std::span<const CoarseView> views, const DirectionSphere& sphere,
                   std::span<const Plane> planes, unsigned threads);

/// For each direction, the inverse distance of the ground if it is below the horizon, otherwise one that
/// counts as infinity.
std::vector<float> base_depths(const DirectionSphere& sphere, const Eigen::Vector3d& center, double reach,
                               const std::optional<Plane>& ground);

/// The index of each direction in `shown`, or `none` for directions that are not in `shown`.
std::vector<std::uint32_t> positions_of(const SweptDepths& depths);

}  // namespace vantage
