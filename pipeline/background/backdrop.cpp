#include "pipeline/background/backdrop.h"

#include <algorithm>
#include <cmath>

#include "pipeline/background/depth/depth_smoothing.h"
#include "pipeline/background/depth/refine_depths.h"
#include "pipeline/background/depth/walls_beyond.h"
#include "pipeline/background/view_sample.h"

namespace vantage {
namespace {

/// Square roots of light, where darkness and light look evenly spaced.
Eigen::Array3f root_of(const Eigen::Array3f& ln) { return linear_of(ln).max(0.0f).sqrt(); }

/// A rotation to the cameras' own axes, so that the world's do not matter.
Eigen::Matrix3f frame_of(std::span<const CoarseView> views) {
    const Eigen::Vector3d down = down_direction(views);
    Eigen::Vector3d forward = Eigen::Vector3d::Zero();
    for (const CoarseView& v : views) forward += v.pose.direction();
    forward -= forward.dot(down) * down;
    if (forward.norm() < 1e-3 * double(views.size())) forward = views[0].pose.R.row(0).transpose();
    const Eigen::Vector3d right = down.cross(forward).normalized();
    Eigen::Matrix3f out;
    out << right.cast<float>(), down.cross(right).cast<float>(), down.cast<float>();
    return out;
}

}  // namespace

bool have_parallax(std::span<const CoarseView> views) {
    double farthest = 0, size = 0;
    for (const CoarseView& v : views) {
        farthest = std::max(farthest, (v.pose.center() - views[0].pose.center()).norm());
        size = std::max(size, v.pose.center().norm());
    }
    return views.size() > 1 && farthest > 1e-6 * size;
}

Backdrop estimate_backdrop(std::span<const CoarseView> views, const MeshPlanes& mesh,
                           const BackdropDetail& detail, unsigned threads) {
    Backdrop out{.sphere = direction_sphere(detail.sphere), .center = {}, .positions = {}};
    const Eigen::Matrix3f frame = frame_of(views);
    for (Eigen::Vector3f& d : out.sphere.directions) d = (frame * d).normalized();
    ScenePlanes planes{find_ground(views, mesh), mesh.largest};
    SweptDepths depths = sweep_depths(views, out.sphere, planes, detail.labels, threads);
    out.center = depths.center;
    std::vector<float> inverse = inverse_distances(depths, out.sphere);
    const std::vector<Plane> beyond = walls_beyond(depths, out.sphere, inverse, down_direction(views, mesh));
    if (!beyond.empty()) {
        prefer_planes(depths, views, out.sphere, beyond, threads);
        planes.walls.insert(planes.walls.end(), beyond.begin(), beyond.end());
        inverse = inverse_distances(depths, out.sphere);
    }
    for (int l = 0; l < detail.refinements; ++l) {
        DirectionSphere fine = divided(out.sphere);
        inverse = refine_depths(views, planes, depths, inverse, fine, threads);
        out.sphere = std::move(fine);
    }
    for (std::size_t v = 0; v < inverse.size(); ++v)
        out.positions.push_back(
            (out.center + out.sphere.directions[v].cast<double>() / double(inverse[v])).cast<float>());
    return out;
}

std::vector<Eigen::Array3f> quiet_colors(const Backdrop& backdrop, std::span<const CoarseView> views) {
    constexpr std::size_t enough = 10'000;  // directions: colors are smooth
    constexpr int rounds = 24;
    constexpr float toward_mean = 0.08f;  // per round
    DirectionSphere coarse = direction_sphere(0);
    while (coarse.directions.size() < std::min(enough, backdrop.positions.size())) coarse = divided(coarse);
    const std::size_t n = coarse.directions.size();
    std::vector<Eigen::Array3f> out(n, Eigen::Array3f::Zero()), colors;
    std::vector<std::uint8_t> unknown(n, 1);
    Eigen::Array3f mean = Eigen::Array3f::Zero();
    float known = 0;
    for (std::size_t v = 0; v < n; ++v) {
        colors.clear();
        for (const CoarseView& view : views)
            if (const ViewSample s = sample(view, in_camera(view, backdrop.positions[v]), 1);
                s.kind == ViewSample::open)
                colors.push_back(root_of(s.ln));
        if (colors.empty()) continue;
        out[v] = median(colors);
        mean += out[v];
        ++known;
        unknown[v] = 0;
    }
    mean = known > 0 ? Eigen::Array3f(mean / known) : Eigen::Array3f::Constant(0.5f);
    for (std::size_t v = 0; v < n; ++v)
        if (unknown[v]) out[v] = mean;
    for (int round = 0; round < rounds; ++round) {
        relax(coarse, unknown, 1, out);
        for (std::size_t v = 0; v < n; ++v)
            if (unknown[v]) out[v] += toward_mean * (mean - out[v]);
    }
    out.reserve(backdrop.positions.size());
    for (std::size_t v = n; v < backdrop.positions.size(); ++v) {
        const auto [a, b] = backdrop.sphere.ends[v];
        out.push_back((out[a] + out[b]) / 2);
    }
    for (Eigen::Array3f& c : out) c = c.square();
    return out;
}

}  // namespace vantage
