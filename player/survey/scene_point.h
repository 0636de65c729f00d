#pragma once
#include <Eigen/Core>
#include <optional>
#include <span>

#include "player/plan/plan_scene.h"
#include "player/plan/section_plane.h"
#include "player/survey/measurement.h"
#include "player/survey/ray_cast.h"
#include "player/view/view.h"

namespace vantage {

/// A mesh with its placement in the scene: its point p is at scale * R * p + t, relative to the scene's
/// origin.
struct PlacedMesh {
    const PlanScene* scene;
    Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
    Eigen::Vector3d t = Eigen::Vector3d::Zero();
    double scale = 1;

    Eigen::Vector3d in_scene(const Eigen::Vector3d& p) const { return scale * (R * p) + t; }
    Eigen::Vector3d in_mesh(const Eigen::Vector3d& p) const { return R.transpose() * (p - t) / scale; }
    bool operator==(const PlacedMesh&) const = default;
};

/// Constraints on points that the user sets.
struct Snapping {
    std::span<const SectionPlane> sections{};  ///< excludes points that these planes of the scene cut away
    double vertex_pixels =
        0;  ///< snaps to the nearest visible vertex within this distance in the picture; 0 disables snapping
};

/// The nearest point on the meshes at `pixel` in the view's picture, in coordinates of the scene's first
/// input, whose origin is `origin`. Its uncertainty comes from the photos that see it and, unless it is a
/// vertex, from pointing to within half a pixel of the view. Returns nullopt beside the surface.
std::optional<SurveyPoint> scene_point(std::span<const PlacedMesh> meshes, const Eigen::Vector3d& origin,
                                       const View& view, const Eigen::Vector2d& pixel,
                                       Snapping snapping = {});

/// Like scene_point() for a pixel, but along a ray in the scene, and without an uncertainty of pointing.
std::optional<SurveyPoint> scene_point(std::span<const PlacedMesh> meshes, const Eigen::Vector3d& origin,
                                       const Ray& ray, std::span<const SectionPlane> sections = {});

/// A point on a surface, relative to the scene's origin, and its unit normal, which points toward the viewer.
struct SurfacePoint {
    Eigen::Vector3d at, normal;
};
/// The first surface point on a ray, at a distance of at most `farthest` times the length of the ray's
/// direction vector. Returns nullopt if the triangle is degenerate.
std::optional<SurfacePoint> surface_on(std::span<const PlacedMesh> meshes, const Ray& ray, double farthest,
                                       std::span<const SectionPlane> sections = {});

}  // namespace vantage
