#pragma once
#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "pipeline/prepare.h"
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

/// Into a photo's or a registration's record: a pose relative to the origin.
template <class Record>
void set_pose(const Pose& pose, Record& r) {
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(r.R) = pose.R;
    Eigen::Map<Eigen::Vector3d>(r.t) = pose.t;
}

/// A record a photo, in the scene's order; what the photos' stages find out is left empty. Throws
/// Error(usage) for a photo to hold out that the scene has not.
std::vector<package::PhotoRecord> photo_records(const SceneInput& scene, const PrepareSettings& settings,
                                                const Eigen::Vector3d& origin);

/// What a package's layout depends on, besides its photos.
struct LayoutSizes {
    std::uint64_t meta_bytes;
    bool colors;  ///< the mesh has them
};
/// Every chunk in file order, coarse before fine; of the photos' chunks, those of a share. Photos that were
/// left out have their place.
std::vector<ChunkPlan> plan_chunks(const package::SceneRecord& scene, const LayoutSizes& sizes,
                                   std::span<const package::PhotoRecord> photos, Share share = {});
/// XXH3-64 of the photos' names, in order.
std::uint64_t names_checksum(std::span<const package::PhotoRecord> photos);

/// The chunks that belong to the scene and not to a photo, but for META and PHOT.
void write_model(PackageWriter& writer, const PackedModel& model, const Mesh& mesh);

}  // namespace vantage
