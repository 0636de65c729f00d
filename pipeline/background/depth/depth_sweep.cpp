#include "pipeline/background/depth/depth_sweep.h"

#include <algorithm>
#include <cmath>

#include "pipeline/background/depth/place_cost.h"

namespace vantage {
namespace {

constexpr float nearest = 1.0f;          ///< largest inverse distance minus the base's, times the reach
constexpr float infinite = 1.0f / 4096;  ///< an inverse distance, times the reach, that counts as infinity

struct Cameras {
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    double reach = 0;
};
Cameras cameras_of(std::span<const CoarseView> views) {
    Cameras c;
    for (const CoarseView& v : views) c.center += v.pose.center() / double(views.size());
    for (const CoarseView& v : views)
        c.reach += (v.pose.center() - c.center).squaredNorm() / double(views.size());
    c.reach = std::sqrt(c.reach);
    return c;
}

float cost_at(const SweptDepths& d, const PlaceCost& cost, const PlaceCost::Sights& sights,
              std::uint32_t direction, float inverse) {
    return cost(sights, inverse) + (inverse > d.most[direction] ? DepthPriors::inside : 0);
}

/// Averages the costs of each direction with those of its neighbors, which have similar content and
/// independent noise.
void average(SweptDepths& d, const DirectionSphere& sphere) {
    const std::vector<std::uint32_t> at = positions_of(d);
    const auto n = std::size_t(d.labels);
    std::vector<float> out(d.cost.size());
    for (std::size_t i = 0; i < d.shown.size(); ++i) {
        float* sum = &out[i * n];
        float weights = 2;
        for (std::size_t l = 0; l < n; ++l) sum[l] = 2 * d.cost[i * n + l];
        for (const std::uint32_t u : sphere.neighbors[d.shown[i]]) {
            if (u == DirectionSphere::none || at[u] == DirectionSphere::none) continue;
            for (std::size_t l = 0; l < n; ++l) sum[l] += d.cost[at[u] * n + l];
            ++weights;
        }
        for (std::size_t l = 0; l < n; ++l) sum[l] /= weights;
    }
    d.cost = std::move(out);
}

/// The inverse distance of a plane in each shown direction; 0 outside the range of the labels.
std::vector<float> plane_depths(const SweptDepths& d, const DirectionSphere& sphere, const Plane& plane) {
    std::vector<float> out;
    for (const std::uint32_t v : d.shown) {
        const float w = inverse_distance(plane, d.center, sphere.directions[v]);
        const bool labelled = w > d.base[v] && w < d.base[v] + d.step * float(d.labels - 1);
        out.push_back(labelled ? w : 0);
    }
    return out;
}

/// Lowers the cost of the labels next to a plane to slightly below that of the plane itself, because walls
/// and floors extend beyond the mesh.
void prefer_plane(SweptDepths& d, const DirectionSphere& sphere, const PlaceCost& cost,
                  const std::vector<float>& plane, unsigned threads) {
    SweptDepths on_plane;
    on_plane.labels = 1;
    on_plane.base = d.base;
    on_plane.shown = d.shown;
    on_plane.cost.assign(d.shown.size(), PlaceCost::largest);
    for_each_direction(d.shown.size(), threads, [&](std::size_t i) {
        if (!(plane[i] > 0)) return;
        thread_local PlaceCost::Sights sights;
        cost.aim(sphere.directions[d.shown[i]], plane[i], plane[i], sights);
        on_plane.cost[i] = cost_at(d, cost, sights, d.shown[i], plane[i]);
    });
    average(on_plane, sphere);
    average(on_plane, sphere);
    for (std::size_t i = 0; i < d.shown.size(); ++i) {
        if (!(plane[i] > 0)) continue;
        const auto label = std::size_t(std::lround((plane[i] - d.base[d.shown[i]]) / d.step));
        float& least = d.cost[i * std::size_t(d.labels) + label];
        least = std::min(least, on_plane.cost[i] + DepthPriors::of_label(float(label), d.labels)) -
                DepthPriors::on_a_plane;
    }
}

}  // namespace

std::vector<float> base_depths(const DirectionSphere& sphere, const Eigen::Vector3d& center, double reach,
                               const std::optional<Plane>& ground) {
    std::vector<float> base(sphere.directions.size(), infinite / float(reach));
    if (!ground || !(ground->height - ground->normal.dot(center) > 0)) return base;
    for (std::size_t v = 0; v < base.size(); ++v)
        base[v] = std::max(base[v], inverse_distance(*ground, center, sphere.directions[v]));
    return base;
}

std::vector<std::uint32_t> positions_of(const SweptDepths& d) {
    std::vector<std::uint32_t> out(d.base.size(), DirectionSphere::none);
    for (std::uint32_t i = 0; i < d.shown.size(); ++i) out[d.shown[i]] = i;
    return out;
}

SweptDepths sweep_depths(std::span<const CoarseView> views, const DirectionSphere& sphere,
                         const ScenePlanes& planes, int labels, unsigned threads) {
    const Cameras cameras = cameras_of(views);
    SweptDepths d;
    d.center = cameras.center;
    d.reach = cameras.reach;
    d.labels = labels;
    d.step = nearest / float(d.reach) / float(labels - 1);
    d.base = base_depths(sphere, d.center, d.reach, planes.ground);
    const PlaceCost cost(views, d.center);
    const std::size_t n = sphere.directions.size();
    for (const Eigen::Vector3f& direction : sphere.directions) d.most.push_back(cost.innermost(direction));
    const auto inverse_of = [&](std::size_t v, int label) { return d.base[v] + float(label) * d.step; };
    const auto aim = [&](std::size_t v, PlaceCost::Sights& sights) {
        cost.aim(sphere.directions[v], inverse_of(v, 0), inverse_of(v, labels - 1), sights);
    };
    std::vector<std::uint8_t> shown(n, 0);
    for_each_direction(n, threads, [&](std::size_t v) {
        thread_local PlaceCost::Sights sights;
        aim(v, sights);
        for (int label = 0; label < labels && !shown[v]; label += 8)
            shown[v] = cost.is_shown(sights, inverse_of(v, label));
    });
    for (std::uint32_t v = 0; v < n; ++v)
        if (shown[v]) d.shown.push_back(v);
    d.cost.resize(d.shown.size() * std::size_t(labels));
    for_each_direction(d.shown.size(), threads, [&](std::size_t i) {
        thread_local PlaceCost::Sights sights;
        aim(d.shown[i], sights);
        for (int label = 0; label < labels; ++label)
            d.cost[i * std::size_t(labels) + std::size_t(label)] =
                cost_at(d, cost, sights, d.shown[i], inverse_of(d.shown[i], label));
    });
    average(d, sphere);
    average(d, sphere);
    for (std::size_t i = 0; i < d.shown.size(); ++i)
        for (int l = 1; l < labels; ++l)
            d.cost[i * std::size_t(labels) + std::size_t(l)] += DepthPriors::of_label(float(l), labels);
    prefer_planes(d, views, sphere, planes.walls, threads);
    return d;
}

void prefer_planes(SweptDepths& d, std::span<const CoarseView> views, const DirectionSphere& sphere,
                   std::span<const Plane> planes, unsigned threads) {
    const PlaceCost cost(views, d.center);
    for (const Plane& plane : planes) {
        d.planes.push_back(plane_depths(d, sphere, plane));
        prefer_plane(d, sphere, cost, d.planes.back(), threads);
    }
}

}  // namespace vantage
