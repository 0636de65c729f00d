#include "player/plan/visible_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace vantage {
namespace {

constexpr double agreement_angle = 0.35;  ///< radians; wider than the blend's, to rank distant photos as well

/// Pixels that a cluster's bounding sphere covers, at most those of the frame, even for NaN.
double area_in_view(const package::ClusterRecord& c, const View& view) {
    const Intrinsics& k = view.intrinsics;
    const double z = (view.cam_from_origin.R * center(c) + view.cam_from_origin.t).z();
    const double reach = std::max(z, double(c.radius)), r = c.radius / reach;
    return std::min(double(k.width) * k.height, std::numbers::pi * r * r * k.fx * k.fy);
}

/// One point on each of up to 8192 triangles, spread by the plastic ratio's sequence (Roberts 2018).
/// `looked`: the number of pixels at which triangles were sampled.
VisibleSurface::Points points_on(const PlanScene& scene, const View& view,
                                 std::span<const std::uint32_t> triangles,
                                 std::span<const std::uint32_t> clusters, std::size_t looked,
                                 double samples) {
    constexpr std::size_t most = 8192;
    VisibleSurface::Points out;
    const std::size_t step = std::max<std::size_t>(1, triangles.size() / most);
    out.samples.reserve(triangles.size() / step + 1);
    for (std::size_t i = 0; i < triangles.size(); i += step) {
        Eigen::Vector3d corner[3];
        for (std::size_t v = 0; v < 3; ++v) {
            const std::size_t vertex = scene.indices[3 * std::size_t(triangles[i]) + v];
            corner[v] = scene.positions[std::min(vertex, scene.positions.size() - 1)].cast<double>();
        }
        const auto share = [&](double step) { return double(i) * step - std::floor(double(i) * step); };
        double a = share(0.7548776662466927), b = share(0.5698402909980532);
        if (a + b > 1) a = 1 - a, b = 1 - b;
        const Eigen::Vector3d e = corner[1] - corner[0], f = corner[2] - corner[0];
        const Eigen::Vector3d point = corner[0] + a * e + b * f;
        const auto seen = project(view.intrinsics, view.cam_from_origin, point);
        const auto s = surface_sample(view, point, e.cross(f).normalized(), samples);
        if (!s || !seen || !in_frame(view.intrinsics, seen->pixel)) continue;
        out.samples.push_back(*s);
        out.triangles.push_back(triangles[i]);
        out.clusters.push_back(clusters[i]);
    }
    if (looked > 0)
        out.pixels = double(view.intrinsics.width) * view.intrinsics.height / double(looked) * double(step) *
                     samples * samples;
    return out;
}

}  // namespace

VisibleSurface visible_surface(const PlanScene& scene, const View& view, std::span<const std::uint32_t> seen,
                               double samples, bool background) {
    VisibleSurface s{scene, view, view.cam_from_origin.center(),
                     clusters_in_view(scene.tree, scene.clusters, view)};
    if (!background) std::erase_if(s.clusters, [&](std::uint32_t c) { return c >= scene.first_surrounding; });
    const auto is_transparent = [&](std::uint32_t c) {
        return c >= scene.first_transparent && c < scene.first_surrounding;
    };
    std::ranges::copy_if(s.clusters, std::back_inserter(s.transparent), is_transparent);
    std::erase_if(s.clusters, is_transparent);
    const std::vector<std::uint32_t> all = clusters_of(scene, seen);
    std::vector<std::uint32_t> count(scene.clusters.size(), 0), clusters;
    s.triangles.reserve(seen.size());
    clusters.reserve(seen.size());
    for (std::size_t i = 0; i < seen.size(); ++i) {
        if (all[i] == ~0u) continue;
        ++count[all[i]];
        s.triangles.push_back(seen[i] - 1);
        clusters.push_back(all[i]);
    }
    s.points = points_on(scene, view, s.triangles, clusters, seen.size(), samples);
    for (const std::uint32_t n : count) s.seen.push_back(n > 0);
    const auto guessed = [&](std::uint32_t c) {
        // Nearly all of the frame is in the sphere around a cluster that reaches to the horizon.
        return area_in_view(scene.clusters[c], view) * (c < scene.first_surrounding ? 1 : 1e-4);
    };
    for (const std::uint32_t c : s.clusters) s.areas.push_back(s.triangles.empty() ? guessed(c) : count[c]);
    return s;
}

double agreement(const VisibleSurface& s, std::uint32_t photo) {
    // At most about 512 clusters, evenly drawn from those in view: enough to rank photos.
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
