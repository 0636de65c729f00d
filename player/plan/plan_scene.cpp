#include "player/plan/plan_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/package/contents/background.h"
#include "scene/package/contents/opaque_part.h"
#include "scene/package/package_shape.h"

namespace vantage {
namespace {

/// The number of mesh triangles, rounded up to whole words of VISB; the triangles of the background follow.
std::uint32_t first_triangle_behind(std::size_t triangles) {
    return std::uint32_t(64 * package::visible_words(triangles));
}

/// The mesh's bits followed by the background's, first for triangles seen entirely, then for triangles seen
/// in part.
std::vector<std::uint64_t> joined_bits(std::span<const std::uint64_t> mesh,
                                       const std::vector<std::uint64_t>& behind) {
    const std::size_t m = mesh.size() / 2, n = behind.size() / 2;
    std::vector<std::uint64_t> out;
    for (const std::size_t half : {0, 1}) {
        const auto of_mesh = mesh.subspan(half * m, m);
        out.insert(out.end(), of_mesh.begin(), of_mesh.end());
        const auto from = behind.begin() + std::ptrdiff_t(half * n);
        out.insert(out.end(), from, from + std::ptrdiff_t(n));
    }
    return out;
}

void join_geometry(PlanScene& s, const BackgroundContent& content) {
    auto& [positions, indices, coverage, visible] = s.joined;
    positions.assign(s.positions.begin(), s.positions.end());
    positions.insert(positions.end(), content.positions.begin(), content.positions.end());
    indices.assign(s.indices.begin(), s.indices.end());
    for (const std::size_t t : content.hidden) indices[3 * t + 1] = indices[3 * t + 2] = indices[3 * t];
    // Adds unused triangles to fill the last word of the mesh's bits.
    const std::uint32_t first = first_triangle_behind(s.triangles);
    indices.resize(3 * std::size_t(first), 0);
    s.first_surrounding = std::uint32_t(s.clusters.size());
    const auto vertices = std::uint32_t(s.positions.size());
    for (const auto& t : content.triangles)
        for (const std::uint32_t v : t) indices.push_back(vertices + v);
    for (package::ClusterRecord c : content.clusters) {
        c.first_triangle += first;
        s.clusters.push_back(c);
    }
    s.positions = positions;
    s.indices = indices;
    s.triangles = indices.size() / 3;
    s.surrounding_colors = content.colors;
    s.surrounding_corrections = content.corrections;
    s.labels = content.labels;
}

/// The spread of the cameras of the first image set, whose photos show the background.
double spread_of(const PlanScene& s) {
    std::vector<Pose> poses;
    for (std::size_t i = 0; i < s.poses.size(); ++i)
        if (s.photos[i].image_set == 0) poses.push_back(s.poses[i]);
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Pose& p : poses) mean += p.center() / double(poses.size());
    double squares = 0;
    for (const Pose& p : poses) squares += (p.center() - mean).squaredNorm() / double(poses.size());
    return std::sqrt(squares);
}

/// Appends the background to all data for plans.
void join(PlanScene& s, const BackgroundContent& content) {
    join_geometry(s, content);
    s.joined.coverage.resize(s.photos.size());
    s.joined.visible.resize(s.photos.size());
    for (std::size_t i = 0; i < s.photos.size(); ++i) {
        if (!s.photos[i].levels) continue;
        auto& coverage = s.joined.coverage[i];
        coverage.assign(s.coverage[i].begin(), s.coverage[i].end());
        coverage.insert(coverage.end(), content.coverage[i].begin(), content.coverage[i].end());
        s.joined.visible[i] = joined_bits(s.visible[i], content.visible[i]);
        s.coverage[i] = coverage;
        s.visible[i] = s.joined.visible[i];
    }
}

}  // namespace

double distance_from_cameras(const PlanScene& s, const Eigen::Vector3d& eye) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < s.poses.size(); ++i)
        if (s.photos[i].image_set == 0) nearest = std::min(nearest, (s.poses[i].center() - eye).norm());
    return nearest;
}

PlanScene make_plan_scene(const PackageReader& package) {
    using package::Type;
    const package::SceneRecord& record = package.scene();
    expect_shape(package);
    PlanScene s;
    s.photos = package.photos();
    s.image_sets = read_image_sets(package);
    const auto clusters = package.records<package::ClusterRecord>(Type::clusters);
    s.clusters.assign(clusters.begin(), clusters.end());
    if (effect_on(record, Effect::transparency)) s.first_transparent = opaque_part(package).clusters;
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
    s.lenses = LensTables(package);
    s.spread = spread_of(s);
    if (const auto background = read_background(package)) join(s, *background);
    s.tree = make_cluster_tree(s.clusters);
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
