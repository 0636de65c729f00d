#pragma once
#include <Eigen/Geometry>
#include <filesystem>
#include <string_view>
#include <vector>

namespace vantage {

/// The JSON contents of a glTF 2.0 file, except its meshes.
struct Gltf {
    std::vector<std::filesystem::path> buffers;  ///< its external buffers
    /// Transforms of the nodes of its scene, each relative to its parent, in double precision: parents before
    /// their children, children in the order of the file.
    std::vector<Eigen::Affine3d> nodes;
};

/// Reads the JSON of a .gltf or .glb. Throws Error(input) if the file is not glTF 2.0, if a buffer is missing
/// or outside the file's folder, if the geometry depends on an extension that assimp does not know, or if a
/// node has two parents.
Gltf read_gltf(const std::filesystem::path& file);

/// The file that a glTF in `folder` refers to: the file with the name as written or, if there is none, the
/// file with the name in which %20 and other percent-encoded characters are decoded.
std::filesystem::path gltf_file(const std::filesystem::path& folder, std::string_view uri);

}  // namespace vantage
