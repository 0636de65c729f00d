#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "player/plan/cluster_tree.h"
#include "player/plan/plan_scene.h"
#include "player/plan/selection/shown_tiles.h"
#include "player/view/view.h"

namespace vantage {

/// What a view shows of the model, regardless of the photos.
struct VisibleSurface {
    const PlanScene& scene;
    const View& view;
    Eigen::Vector3d eye;
    std::vector<std::uint32_t> clusters;       ///< in view, opaque
    std::vector<double> areas{};               ///< per cluster in view; any unit, 0: hidden
    std::vector<std::uint32_t> triangles{};    ///< seen, with repetitions; none: unknown
    std::vector<std::uint32_t> transparent{};  ///< clusters in view
    std::vector<bool> seen{};                  ///< per cluster of the scene: some of it was seen
    /// Points on some of the triangles seen, with their triangles and clusters.
    struct Points {
        std::vector<SurfaceSample> samples;
        std::vector<std::uint32_t> triangles, clusters;
        double pixels = 0;  ///< samples of the picture that each point stands for
    } points{};
};

/// `seen`: the triangles at pixels of this view or a recent one, numbered from 1 (0: none). `samples`: per
/// side of a pixel. `background`: whether they are shown.
VisibleSurface visible_surface(const PlanScene& scene, const View& view, std::span<const std::uint32_t> seen,
                               double samples, bool background);

/// How well a photo agrees with the view, in [0, 1]: the share of the visible mesh that it sees, weighted by
/// the angle; 0 if it sees nothing of it.
double agreement(const VisibleSurface& surface, std::uint32_t photo);

/// The photo sees a triangle at least in part.
bool sees(const PlanScene& scene, std::uint32_t photo, std::uint32_t triangle);

/// Angle between the rays from a point to the viewer and to a photo, radians.
double ray_angle(const Eigen::Vector3d& point, const Eigen::Vector3d& eye, const Eigen::Vector3d& photo);

}  // namespace vantage
