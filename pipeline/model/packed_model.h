#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "scene/mesh.h"
#include "scene/package_format.h"
#include "scene/package_writer.h"

namespace vantage {

/// The scene as the package holds it: centred, single precision, ordered by cluster.
struct PackedModel {
    package::SceneRecord record{};
    Eigen::Vector3d origin;
    std::vector<Eigen::Vector3f> positions;
    std::vector<std::uint32_t> indices;
    std::vector<package::ClusterRecord> clusters;
};
/// Orders triangles and vertices of `mesh`, too: triangles by cluster, vertices as the triangles first use
/// them (so that neighbours lie together in memory), unused ones last.
PackedModel pack_model(Mesh& mesh, unsigned cluster_triangles);

/// Writes geometry, clusters and vertex attributes.
void write_model(PackageWriter& writer, const PackedModel& model, const Mesh& mesh);

}  // namespace vantage
