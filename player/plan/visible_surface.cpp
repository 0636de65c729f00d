#include "player/plan/visible_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "player/plan/triangle_corners.h"

namespace vantage {
namespace {

constexpr double agreement_angle = 0.35;  ///< radians; larger than for blending, to rank distant photos

/// Number of pixels covered by a cluster's bounding sphere, at most the number of pixels in the frame. NaN
/// becomes that maximum.
double area_in_view(const package::ClusterRecord& c, const View& view) {
    const Intrinsics& k = view.intrinsics;
    const double z = (view.cam_from_origin.R * center(c) + view.cam_from_origin.t).z();
    const double reach = std::max(z, double(c.radius)), r = c.radius / reach;
    return std::min(double(k.width) * k.height, std::numbers::pi * r * r * k.fx * k.fy);
}

/// The center of a sampled pixel, by its index.
Eigen::Vector2d sampled_pixel(FrameSize frame, std::size_t number) {
    const FrameSize n = Seen::samples(frame);
    const double x = double(number % std::size_t(n.width)) + 0.5,
                 y = double(number / std::size_t(n.width)) + 0.5;
    return {std::floor(x * frame.width / n.width) + 0.5, std::floor(y * frame.height / n.height) + 0.5};
}

/// One of a triangle's points, which are distributed by the plastic ratio's sequence (Roberts 2018).
Eigen::Vector3d spread_point(const Corners& corner, std::size_t number) {
    const auto share = [&](double step) { return double(number) * step - std::floor(double(number) * step); };
    double a = share(0.7548776662466927), b = share(0.5698402909980532);
    if (a + b > 1) a = 1 - a, b = 1 - b;
    return corner[0] + a * (corner[1] - corner[0]) + b * (corner[2] - corner[0]);
}

/// Selects about `most` evenly spaced visible triangles on which to place points. Returns the number of
/// triangles that each selected triangle represents.
double draw_points(const Seen& seen, std::size_t most, std::vector<std::size_t>& out) {
    const std::size_t all = seen.triangles.size();
    if (!seen.view) {
        const std::size_t step = std::max<std::size_t>(1, all / most);
        for (std::size_t i = 0; i < all; i += step) out.push_back(i);
        return double(step);
    }
    const auto columns = std::size_t(Seen::samples(frame_size(*seen.view)).width), rows = all / columns;
    const auto step = std::max<std::size_t>(1, std::size_t(std::sqrt(double(all) / double(most)) + 0.5));
    for (std::size_t y = step / 2; y < rows; y += step)
        for (std::size_t x = step / 2; x < columns; x += step) out.push_back(y * columns + x);
    return double(step * step);
}

/// All visible triangles; for a plan in motion, an evenly spaced sample, which is enough to rank photos.
std::vector<std::uint32_t> drawn_triangles(const Seen& seen, const PlanSettings& settings) {
    constexpr std::size_t most = 4096;
    // An odd step, so that it does not divide the number of rows.
    const std::size_t step = settings.complete ? 1 : seen.triangles.size() / most | 1;
    std::vector<std::uint32_t> out;
    out.reserve(seen.triangles.size() / step + 1);
    for (std::size_t i = 0; i < seen.triangles.size(); i += step) out.push_back(seen.triangles[i]);
    return out;
}

VisibleSurface::Points points_on(const PlanScene& scene, const View& view, const Seen& seen,
                                 const PlanSettings& settings) {
    constexpr std::size_t most = 2048, most_if_complete = 65536;
    std::vector<std::size_t> drawn;
    const double each = draw_points(seen, settings.complete ? most_if_complete : most, drawn);
    std::vector<std::uint32_t> numbers;
    for (const std::size_t i : drawn) numbers.push_back(seen.triangles[i]);
    const std::vector<std::uint32_t> clusters = clusters_of(scene, numbers);
    VisibleSurface::Points out;
    out.samples.reserve(drawn.size());
    for (std::size_t n = 0; n < drawn.size(); ++n) {
        if (clusters[n] == ~0u) continue;
        const std::size_t i = drawn[n];
        const std::uint32_t triangle = seen.triangles[i] - 1;
        const std::optional<Corners> corners = corners_of(scene, triangle);
        if (!corners) continue;
        const Corners& corner = *corners;
        Eigen::Vector3d point = spread_point(corner, i);
        if (seen.view) {
            const Ray ray = ray_through(*seen.view, sampled_pixel(frame_size(*seen.view), i));
            if (const double away = meets(ray, corner, 1e-3); std::isfinite(away))
                point = ray.from + away * ray.along;
        }
        const Eigen::Vector3d normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]).normalized();
        const auto shown = project(view.intrinsics, view.cam_from_origin, point);
        const auto s = surface_sample(view, point, normal, settings.samples);
        if (!s || !shown || !in_frame(view.intrinsics, shown->pixel)) continue;
        out.samples.push_back(*s);
        out.triangles.push_back(triangle);
        out.clusters.push_back(clusters[n]);
    }
    if (seen.triangles.empty()) return out;
    const double pixels =
        double(view.intrinsics.width) * view.intrinsics.height / double(seen.triangles.size()) * each;
    out.pixels = pixels * settings.samples * settings.samples;
    return out;
}

}  // namespace

void find_clusters(const PlanScene& scene, const View& view, bool background, ClustersInView& found) {
    find_clusters_in_view(scene.tree, scene.clusters, view, found.opaque);
    if (!background)
        std::erase_if(found.opaque, [&](std::uint32_t c) { return c >= scene.first_surrounding; });
    const auto first = std::ranges::lower_bound(found.opaque, scene.first_transparent),
               end = std::ranges::lower_bound(found.opaque, scene.first_surrounding);
    if (first < end) {
        found.transparent.assign(first, end);
        found.opaque.erase(first, end);
    } else {
        found.transparent.clear();
    }
}

VisibleSurface visible_surface(const PlanScene& scene, const View& view, const Seen& seen,
                               const PlanSettings& settings) {
    ClustersInView in_view;
    const double margin = seen.triangles.empty() ? 0 : settings.margin * view.intrinsics.width;
    find_clusters(scene, widened(view, int(margin)), settings.background, in_view);
    VisibleSurface s{scene, view, view.cam_from_origin.center(), std::move(in_view.opaque)};
    const std::vector<std::uint32_t> numbers = drawn_triangles(seen, settings);
    const std::vector<std::uint32_t> clusters = clusters_of(scene, numbers);
    std::vector<std::uint32_t> count(scene.clusters.size(), 0);
    s.triangles.reserve(numbers.size());
    s.clusters_of_triangles.reserve(numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (clusters[i] == ~0u) continue;
        ++count[clusters[i]];
        s.triangles.push_back(numbers[i] - 1);
        s.clusters_of_triangles.push_back(clusters[i]);
    }
    s.points = points_on(scene, view, seen, settings);
    const auto guessed = [&](std::uint32_t c) {
        // The bounding sphere of a background cluster that reaches the horizon covers nearly all of the
        // frame.
        return area_in_view(scene.clusters[c], view) * (c < scene.first_surrounding ? 1 : 1e-4);
    };
    for (const std::uint32_t c : s.clusters) s.areas.push_back(s.triangles.empty() ? guessed(c) : count[c]);
    return s;
}

double agreement(const VisibleSurface& s, std::uint32_t photo) {
    // At most about 512 clusters in view, evenly spaced, which are enough to rank photos.
    const auto& coverage = s.scene.coverage[photo];
    if (coverage.empty()) return 0;
    const Eigen::Vector3d from = s.scene.poses[photo].center();
    const std::size_t step = std::max<std::size_t>(1, s.clusters.size() / 512);
    double agrees = 0, all = 0;
    for (std::size_t i = 0; i < s.clusters.size(); i += step) {
        const std::uint32_t c = s.clusters[i];
        if (s.areas[i] == 0 || c >= s.scene.first_surrounding) continue;
        all += s.areas[i];
        if (coverage[c].seen == 0) continue;
        agrees += s.areas[i] * coverage[c].seen / 65535.0 *
                  std::exp(-ray_angle(center(s.scene.clusters[c]), s.eye, from) / agreement_angle);
    }
    return all > 0 ? agrees / all : 0;
}

bool sees(const PlanScene& scene, std::uint32_t photo, std::uint32_t t) {
    return scene.visible[photo][package::visible_words(scene.triangles) + t / 64] >> (t % 64) & 1;
}

double ray_angle(const Eigen::Vector3d& point, const Eigen::Vector3d& eye, const Eigen::Vector3d& photo) {
    const Eigen::Vector3d a = eye - point, b = photo - point;
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace vantage
