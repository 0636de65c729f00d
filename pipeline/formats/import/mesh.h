#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "scene/mesh.h"

namespace vantage {

/// Reads PLY (read_ply), and OBJ, STL or OFF through OpenMesh, without its half-edge structure, so that
/// non-manifold faces stay. Polygons become fans; triangles with repeated, missing or non-finite vertices
/// (beyond 1e18, too) are dropped and counted in `warnings`; vertices of no triangle stay, but not their
/// places. Normals are unit length, made from the faces (by area) where the file has none.
/// From OBJ, STL and OFF positions come in single precision. Throws Error(input).
Mesh read_mesh(const std::filesystem::path& file, std::vector<std::string>& warnings);

}  // namespace vantage
