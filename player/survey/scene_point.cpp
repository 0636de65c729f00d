#include "player/survey/scene_point.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "player/survey/footprint.h"
#include "player/survey/ray_cast.h"
#include "player/survey/section.h"

namespace vantage {
namespace {

/// The standard uncertainty of pointing, in pixels of the view.
constexpr double pointing_pixels = 0.5;

/// A point on one of the meshes, relative to the scene's origin.
struct Found {
    const PlacedMesh* mesh;
    std::uint32_t triangle;
    double distance;  ///< as a multiple of the ray's direction vector
    Eigen::Vector3d position;
};

std::optional<Found> nearest(std::span<const PlacedMesh> meshes, const Ray& ray,
                             std::span<const SectionPlane> sections,
                             double farthest = std::numeric_limits<double>::infinity()) {
    std::optional<Found> out;
    RayRange range = behind(sections, ray);
    range.farthest = std::min(range.farthest, farthest);
    for (const PlacedMesh& m : meshes) {
        const Ray own{m.in_mesh(ray.from), m.R.transpose() * ray.along / m.scale};
        const auto hit = first_hit(*m.scene, own, range);
        if (hit && (!out || hit->distance < out->distance))
            out = Found{&m, hit->triangle, hit->distance, ray.from + ray.along * hit->distance};
    }
    return out;
}

/// Whether a vertex is unobstructed, within single precision.
bool in_sight(std::span<const PlacedMesh> meshes, const View& view, const Eigen::Vector3d& position,
              std::span<const SectionPlane> sections) {
    const Ray ray{view.cam_from_origin.center(), position - view.cam_from_origin.center()};
    const auto hit = nearest(meshes, ray, sections);
    const double length = ray.along.norm();
    return !hit || length * (1 - hit->distance) < 1e-4 * scale_at(view, length);
}

/// The visible vertex that is nearest in the picture, among those of the triangles around the pixel.
std::optional<Found> nearest_vertex(std::span<const PlacedMesh> meshes, const View& view,
                                    const Eigen::Vector2d& pixel, const Snapping& snapping) {
    constexpr int around = 8;
    double reach = snapping.vertex_pixels;
    std::optional<Found> best;
    const auto look = [&](const Eigen::Vector2d& at) {
        const auto found = nearest(meshes, ray_through(view, at), snapping.sections);
        if (!found) return;
        const PlanScene& scene = *found->mesh->scene;
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t v = scene.indices[3 * std::size_t(found->triangle) + c];
            const Eigen::Vector3d p = found->mesh->in_scene(scene.positions[v].cast<double>());
            const auto shown = project(view.intrinsics, view.cam_from_origin, p);
            const double off = shown ? (shown->pixel - pixel).norm() : reach;
            const bool cut_away = is_cut_away(snapping.sections, p);
            if (off >= reach || cut_away || !in_sight(meshes, view, p, snapping.sections)) continue;
            reach = off;
            best = Found{found->mesh, found->triangle, 0, p};
        }
    };
    look(pixel);
    for (const double radius : {reach / 2, reach})
        for (int i = 0; i < around; ++i) {
            const double turn = 2 * std::numbers::pi * i / around;
            look(pixel + radius * Eigen::Vector2d(std::cos(turn), std::sin(turn)));
        }
    return best;
}

/// The found point, with the uncertainty from its photos and, if given, that of pointing in a view.
std::optional<SurveyPoint> survey_point(const std::optional<Found>& found, const Eigen::Vector3d& origin,
                                        const View* pointed = nullptr) {
    if (!found || !found->position.allFinite()) return {};
    const PlacedMesh& m = *found->mesh;
    SurveyPoint out{found->position + origin};
    if (const auto pixel_size = smallest_footprint(*m.scene, found->triangle, m.in_mesh(found->position))) {
        out.uncertainty = pixel_size->size * m.scale;
        out.photo = m.scene->photos[pixel_size->photo].name;
    }
    if (pointed) {
        const Intrinsics& k = pointed->intrinsics;
        out.pointing = pointing_pixels * depth_in(*pointed, found->position) / std::sqrt(k.fx * k.fy);
    }
    return out;
}

}  // namespace

std::optional<SurveyPoint> scene_point(std::span<const PlacedMesh> meshes, const Eigen::Vector3d& origin,
                                       const View& view, const Eigen::Vector2d& pixel, Snapping snapping) {
    if (snapping.vertex_pixels > 0)
        if (const auto vertex = nearest_vertex(meshes, view, pixel, snapping))
            return survey_point(vertex, origin);
    return survey_point(nearest(meshes, ray_through(view, pixel), snapping.sections), origin, &view);
}

std::optional<SurveyPoint> scene_point(std::span<const PlacedMesh> meshes, const Eigen::Vector3d& origin,
                                       const Ray& ray, std::span<const SectionPlane> sections) {
    return survey_point(nearest(meshes, ray, sections), origin);
}

std::optional<SurfacePoint> surface_on(std::span<const PlacedMesh> meshes, const Ray& ray, double farthest,
                                       std::span<const SectionPlane> sections) {
    const auto found = nearest(meshes, ray, sections, farthest);
    if (!found) return {};
    const PlanScene& scene = *found->mesh->scene;
    const auto corner = [&](std::size_t c) -> Eigen::Vector3d {
        return scene.positions[scene.indices[3 * std::size_t(found->triangle) + c]].cast<double>();
    };
    Eigen::Vector3d normal = found->mesh->R * (corner(1) - corner(0)).cross(corner(2) - corner(0));
    if (!(normal.norm() > 0)) return {};
    normal.normalize();
    if (normal.dot(ray.along) > 0) normal = -normal;
    return SurfacePoint{found->position, normal};
}

}  // namespace vantage
