#include "player/plan/plan_scene.h"

#include <algorithm>

#include "scene/package_shape.h"

namespace vantage {

PlanScene make_plan_scene(const PackageReader& package) {
    using package::Type;
    const package::SceneRecord& record = package.scene();
    expect_shape(package);
    PlanScene s;
    s.photos = package.photos();
    const auto clusters = package.records<package::ClusterRecord>(Type::clusters);
    s.clusters.assign(clusters.begin(), clusters.end());
    s.tree = make_cluster_tree(s.clusters);
    s.size = bounds_from_origin(record).diagonal().norm();
    s.triangles = record.triangles;
    s.positions = package.records<Eigen::Vector3f>(Type::positions);
    s.indices = package.records<std::uint32_t>(Type::indices);
    for (std::uint32_t i = 0; i < s.photos.size(); ++i) {
        s.intrinsics.push_back(intrinsics(s.photos[i]));
        s.poses.push_back(cam_from_origin(s.photos[i]));
        s.coverage.emplace_back();
        s.visible.emplace_back();
        if (!s.photos[i].levels) continue;
        s.coverage.back() = package.records<package::CoverageRecord>(Type::coverage, i);
        s.visible.back() = package.records<std::uint64_t>(Type::visible, i);
    }
    return s;
}

std::vector<std::uint32_t> clusters_of(const PlanScene& scene, std::span<const std::uint32_t> triangles) {
    const auto holds = [&](std::size_t c, std::uint32_t t) {
        return t - scene.clusters[c].first_triangle < scene.clusters[c].triangles;
    };
    std::vector<std::uint32_t> out(triangles.size(), ~0u);
    std::size_t cluster = 0;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const std::uint32_t t = triangles[i] - 1;
        if (triangles[i] == 0 || t >= scene.triangles) continue;
        if (!holds(cluster, t))  // neighbors are mostly in the same cluster
            cluster = std::size_t(
                std::ranges::upper_bound(scene.clusters, t, {}, &package::ClusterRecord::first_triangle) -
                scene.clusters.begin() - 1);
        out[i] = std::uint32_t(cluster);
    }
    return out;
}

}  // namespace vantage
