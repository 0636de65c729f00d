#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "player/plan/plan_scene.h"
#include "player/plan/shown_tiles.h"
#include "player/view.h"

namespace vantage {

/// The view with what does not depend on the photos.
struct Sight {
    const PlanScene& scene;
    const View& view;
    Eigen::Vector3d eye;
    std::vector<std::uint32_t> clusters;
    std::vector<double> areas{};           ///< of clusters; any unit, 0: not seen
    std::vector<std::uint32_t> samples{};  ///< triangles seen, with repetitions; none: unknown
    std::vector<bool> shown{};             ///< a cluster: some of it was seen
    /// Some of the samples, as surfaces, with their triangles and clusters.
    struct Surface {
        std::vector<SurfaceSample> samples;
        std::vector<std::uint32_t> triangles, clusters;
        double pixels = 0;  ///< of the view, that one of them stands for
    } surface{};
};

/// `seen` are triangles that samples of the view (or one just before) showed, from 1, 0 for none; `samples`
/// along a pixel's side.
Sight look(const PlanScene& scene, const View& view, std::span<const std::uint32_t> seen, double samples);

/// How well a photo agrees with the view: share of it seen, by angle, in [0, 1]; 0 where it sees nothing of
/// it.
double agreement(const Sight& sight, std::uint32_t photo);

/// A photo sees some of a triangle.
bool sees(const PlanScene& scene, std::uint32_t photo, std::uint32_t triangle);

Eigen::Vector3d center(const package::ClusterRecord& cluster);
/// Angle between the rays from a point to the viewer and to a photo.
double ray_angle(const Eigen::Vector3d& point, const Eigen::Vector3d& eye, const Eigen::Vector3d& photo);

}  // namespace vantage
