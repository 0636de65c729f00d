#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "player/plan/cluster_tree.h"
#include "player/plan/plan_scene.h"
#include "player/plan/plan_settings.h"
#include "player/plan/selection/shown_tiles.h"
#include "player/view/view.h"

namespace vantage {

/// The triangles visible in this or a recent view.
struct Seen {
    static constexpr int step = 2;  ///< pixels
    /// The triangles at every second pixel of every second row, from the top; numbered from 1 (0: none).
    std::span<const std::uint32_t> triangles{};
    const View* view = nullptr;  ///< null: the triangles are from several views

    /// Number of sampled pixels of a frame, across and down.
    static FrameSize samples(FrameSize frame) {
        return {std::max(1, frame.width / step), std::max(1, frame.height / step)};
    }
};

/// The clusters that a view may show, in ascending order.
struct ClustersInView {
    std::vector<std::uint32_t> opaque, transparent;
};
/// Excludes the background unless `background` is set.
void find_clusters(const PlanScene& scene, const View& view, bool background, ClustersInView& found);

/// The visible part of the model, independent of the photos.
struct VisibleSurface {
    const PlanScene& scene;
    const View& view;
    Eigen::Vector3d eye;
    std::vector<std::uint32_t> clusters;     ///< in view, opaque
    std::vector<double> areas{};             ///< per cluster in view, in any unit; 0: hidden
    std::vector<std::uint32_t> triangles{};  ///< visible triangles, with repetitions; empty: unknown
    std::vector<std::uint32_t> clusters_of_triangles{};  ///< one per triangle
    /// Points on some of the visible triangles, with their triangles and clusters.
    struct Points {
        std::vector<SurfaceSample> samples;
        std::vector<std::uint32_t> triangles, clusters;
        double pixels = 0;  ///< samples of the picture represented by each point
    } points{};
};

/// Excludes the background unless enabled in `settings`. Complete pictures have more points; if the visible
/// triangles are known, clusters within `settings.margin` of the frame count as in view.
VisibleSurface visible_surface(const PlanScene& scene, const View& view, const Seen& seen,
                               const PlanSettings& settings);

/// Agreement of a photo with the view, in [0, 1]: the fraction of the visible mesh that the photo sees,
/// weighted by the angle; 0 if it sees none of the mesh.
double agreement(const VisibleSurface& surface, std::uint32_t photo);

/// Whether the photo sees a triangle, at least in part.
bool sees(const PlanScene& scene, std::uint32_t photo, std::uint32_t triangle);

/// Angle between the rays from a point to the viewer and to a photo, radians.
double ray_angle(const Eigen::Vector3d& point, const Eigen::Vector3d& eye, const Eigen::Vector3d& photo);

}  // namespace vantage
