#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "player/plan/cluster_tree.h"
#include "player/plan/lens_tables.h"
#include "scene/package/contents/image_sets.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// The input of plans: the package's photos and clusters, and the parts seen by each photo. Spans are valid
/// as long as the package exists. The file may be overwritten while it is in use, so any value in a span may
/// change.
struct PlanScene {
    PlanScene() = default;
    PlanScene(PlanScene&&) = default;  ///< moving a vector keeps the spans of its elements valid
    PlanScene& operator=(PlanScene&&) = default;

    std::span<const package::PhotoRecord> photos;
    std::vector<ImageSet> image_sets;  ///< at least one
    std::vector<package::ClusterRecord> clusters;
    ClusterTree tree;
    std::vector<Intrinsics> intrinsics;                              ///< per photo
    std::vector<Pose> poses;                                         ///< per photo, cam_from_origin
    std::vector<std::span<const package::CoverageRecord>> coverage;  ///< per photo; empty if held out
    std::vector<std::span<const std::uint64_t>> visible;             ///< per photo, as in VISB
    LensTables lenses;
    double spread = 0;  ///< root mean square distance of the first image set's cameras from their mean
    double size = 0;    ///< diagonal of the model's bounds
    std::size_t triangles = 0;
    std::span<const Eigen::Vector3f> positions;
    std::span<const std::uint32_t> indices;

    std::uint32_t first_transparent = ~0u;  ///< cluster of the mesh; past the last if the mesh is opaque
    bool has_transparency() const {
        return first_transparent < std::min<std::size_t>(first_surrounding, clusters.size());
    }
    /// Clusters, triangles and vertices of the background follow those of the mesh.
    std::uint32_t first_surrounding = ~0u;  ///< cluster; past the last if there is no background
    // One element per vertex of the background, see BackgroundContent.
    std::vector<std::array<std::uint8_t, 4>> surrounding_colors;
    std::vector<std::array<std::int8_t, 4>> surrounding_corrections;
    std::vector<std::uint8_t> labels;  ///< per photo; empty without a background
    /// Storage of the spans if there is a background.
    struct Joined {
        std::vector<Eigen::Vector3f> positions;
        std::vector<std::uint32_t> indices;
        std::vector<std::vector<package::CoverageRecord>> coverage;
        std::vector<std::vector<std::uint64_t>> visible;
    } joined;
    /// The parts hidden by hide(), as they were before.
    struct Hidden {
        std::vector<std::pair<std::uint32_t, std::array<std::uint32_t, 3>>> triangles;
        std::vector<std::pair<std::uint32_t, std::array<std::uint8_t, 4>>> colors;  ///< of the background
    } hidden;
    std::span<const package::ClusterRecord> clusters_of_mesh() const {
        return std::span(clusters).first(std::min<std::size_t>(first_surrounding, clusters.size()));
    }
    bool has_background() const { return first_surrounding < clusters.size(); }
    /// First triangle of the background; past the last triangle if there is none.
    std::size_t first_triangle_behind() const {
        return has_background() ? clusters[first_surrounding].first_triangle : triangles;
    }
};
/// Distance from the nearest camera of the first image set, whose photos show the background; infinite if
/// there is no such camera.
double distance_from_cameras(const PlanScene& scene, const Eigen::Vector3d& eye);

/// Throws Error(damaged).
PlanScene make_plan_scene(const PackageReader& package);

/// The cluster of each triangle. Triangles are numbered from 1; the result is 2^32 - 1 for 0 and for numbers
/// out of range.
std::vector<std::uint32_t> clusters_of(const PlanScene& scene, std::span<const std::uint32_t> triangles);

}  // namespace vantage
