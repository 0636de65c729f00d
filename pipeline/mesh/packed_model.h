#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <span>
#include <vector>

#include "base/values/main_box.h"
#include "scene/package/contents/mesh.h"
#include "scene/package/contents/opaque_part.h"
#include "scene/package/package_format.h"
#include "scene/package/package_writer.h"

namespace vantage {

/// The model as stored in the package, with triangles ordered by cluster.
struct PackedModel {
    package::SceneRecord record{};
    Eigen::Vector3d origin;                  ///< center of the mesh's main_box(), in the mesh's coordinates
    std::vector<Eigen::Vector3f> positions;  ///< relative to `origin`
    std::vector<std::uint32_t> indices;      ///< three per triangle
    std::vector<package::ClusterRecord> clusters;
    OpaquePart opaque{};  ///< the part onto which photos are blended

    std::span<const package::ClusterRecord> opaque_clusters() const {
        return std::span(clusters).first(opaque.clusters);
    }
    std::span<const Eigen::Vector3f> opaque_positions() const {
        return std::span(positions).first(opaque.vertices);
    }
    std::span<const std::uint32_t> opaque_indices() const {
        return std::span(indices).first(3 * std::size_t(opaque.triangles));
    }
};

/// Packs `mesh`, and reorders it in the same way: triangles by cluster, and vertices by first use (for memory
/// locality), with unused vertices last. With `transparency`, triangles that are not opaque come last, in
/// separate clusters; otherwise all triangles count as opaque. `box` is the main_box() of the mesh, or of the
/// cloud that the mesh represents.
PackedModel pack_model(Mesh& mesh, const MainBox& box, bool transparency = false);

/// Writes geometry, clusters and vertex attributes. Throws Error(storage).
void write_model(PackageWriter& writer, const PackedModel& model, const Mesh& mesh);

}  // namespace vantage
