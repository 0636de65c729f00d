#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "player/plan/cluster_tree.h"
#include "scene/package_reader.h"

namespace vantage {

/// What plans are made of: the package's photos and clusters, and what each photo sees. Spans live as long as
/// the package; as it may be overwritten while it is shown, what they point to can be any number.
struct PlanScene {
    std::span<const package::PhotoRecord> photos;
    std::vector<package::ClusterRecord> clusters;
    ClusterTree tree;
    std::vector<Intrinsics> intrinsics;                              ///< a photo
    std::vector<Pose> poses;                                         ///< a photo, cam_from_origin
    std::vector<std::span<const package::CoverageRecord>> coverage;  ///< a photo; empty where held out
    std::vector<std::span<const std::uint64_t>> visible;             ///< a photo, as VISB
    std::size_t triangles = 0;
    std::span<const Eigen::Vector3f> positions;
    std::span<const std::uint32_t> indices;
};
/// Throws Error(damaged).
PlanScene make_plan_scene(const PackageReader& package);

/// The cluster of each triangle, numbered from 1; 2^32 - 1 where it is none of the model's, as 0 is.
std::vector<std::uint32_t> clusters_of(const PlanScene& scene, std::span<const std::uint32_t> triangles);

}  // namespace vantage
