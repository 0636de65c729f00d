#pragma once
#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "player/plan/plan_scene.h"
#include "tests/player/test_scene.h"

namespace vantage {

/// A mesh of given triangles, in clusters of up to 64, without photos.
struct MeshScene {
    std::vector<Eigen::Vector3f> positions;
    std::vector<std::uint32_t> indices;
    PlanScene scene;

    void add(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
        for (const Eigen::Vector3d& p : {a, b, c}) {
            indices.push_back(std::uint32_t(positions.size()));
            positions.push_back(p.cast<float>());
        }
    }
    void add_quad(const Eigen::Vector3d& corner, const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
        add(corner, corner + u, corner + u + v);
        add(corner, corner + u + v, corner + v);
    }
    std::array<Eigen::Vector3d, 3> triangle(std::size_t t) const {
        return {positions[3 * t].cast<double>(), positions[3 * t + 1].cast<double>(),
                positions[3 * t + 2].cast<double>()};
    }
    /// Must be called after the last triangle has been added.
    void finish() {
        scene.positions = positions;
        scene.indices = indices;
        scene.triangles = indices.size() / 3;
        for (std::size_t first = 0; first < scene.triangles; first += 64) {
            const std::size_t end = std::min(first + 64, scene.triangles);
            Eigen::AlignedBox3d box;
            for (std::size_t t = first; t < end; ++t)
                for (const Eigen::Vector3d& p : triangle(t)) box.extend(p);
            package::ClusterRecord c = cluster_at(box.center(), box.diagonal().norm() / 2 * (1 + 1e-6));
            c.first_triangle = std::uint32_t(first);
            c.triangles = std::uint32_t(end - first);
            c.cone_cutoff = 1;
            scene.clusters.push_back(c);
        }
        scene.tree = make_cluster_tree(scene.clusters);
    }
    /// Adds a photo in which all triangles within its frame are visible.
    void add_photo(const Pose& pose, double focal_length) {
        scene.intrinsics.push_back({1000, 1000, focal_length, focal_length, 500, 500});
        scene.poses.push_back(pose);
        words.push_back(std::make_unique<std::vector<std::uint64_t>>(
            2 * package::visible_words(scene.triangles), ~std::uint64_t(0)));
        scene.visible.push_back(*words.back());
        records.resize(scene.poses.size());
        scene.photos = records;
    }
    std::vector<std::unique_ptr<std::vector<std::uint64_t>>> words;
    std::vector<package::PhotoRecord> records;
};

}  // namespace vantage
