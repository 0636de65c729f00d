#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "scene/package/contents/mesh.h"

namespace vantage {

/// The result of read_with_assimp().
struct AssimpMesh {
    Mesh mesh;
    double rounding = 0;  ///< largest error of a coordinate due to single precision, input units
    double unit = 0;      ///< unit of an FBX, in cm; 0 if the file states none
    std::vector<std::filesystem::path> buffers{};  ///< external buffers of a glTF
};

/// Reads a .gltf, .glb or .fbx with assimp, in a separate process, because damaged files can crash it. All
/// meshes of the scene are joined, one instance per node that refers to them. Positions have single precision
/// within their mesh, as do the transforms of nodes in FBX. Coordinates are those of the file: neither its
/// axes nor its unit is converted. Polygons are triangulated; lines and points are skipped, but not their
/// vertices. Colors are opaque; those of glTF, which are linear light, become sRGB. Corners that refer to no
/// vertex become `no_vertex`; for a glTF, assimp drops their triangles. Throws Error(input).
AssimpMesh read_with_assimp(const std::filesystem::path& file);

}  // namespace vantage
