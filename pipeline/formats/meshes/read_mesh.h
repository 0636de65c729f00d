#pragma once
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "scene/package/contents/mesh.h"

namespace vantage {

/// The formats of read_mesh(), for messages.
inline constexpr const char* mesh_format_names = "PLY, OBJ, STL, OFF, glTF, GLB, FBX";

/// Whether a file with this name has one of these formats.
bool is_mesh_file(const std::filesystem::path& file);
/// Whether the file is a glTF, GLB or FBX. Nodes in these formats transform meshes: programs rotate and scale
/// them on export.
bool has_nodes(const std::filesystem::path& file);
/// Whether the file is in a USD format, which read_mesh() rejects.
bool is_usd_file(const std::filesystem::path& file);

/// Reads a mesh. PLY, OBJ, text STL and text OFF are read in double precision, and binary STL in single
/// precision. Binary OFF is read by OpenMesh in single precision, without its half-edge structure, so that
/// non-manifold faces are kept. For glTF, GLB and FBX, see read_with_assimp(). Polygons become triangle fans,
/// except in FBX. STL, glTF, GLB and FBX are welded. Triangles with repeated, missing or non-finite vertices,
/// or coordinates of 1e18 or more, are dropped and counted in `warnings`; unreferenced vertices are kept, but
/// moved onto another vertex. Points of a cloud with such coordinates are dropped and counted. Adds the
/// coordinate_warnings() to `warnings`, and the unit that an FBX states unless it is the meter. Normals have
/// unit length; missing ones are area-weighted means of the face normals; clouds without normals keep none.
/// Further files on which the mesh depends go to `companions`: the buffers of a glTF, and the materials of an
/// OBJ (see read_obj()). Throws Error(input).
Mesh read_mesh(const std::filesystem::path& file, std::vector<std::string>& warnings,
               std::vector<std::filesystem::path>* companions = nullptr);

/// A mesh or cloud as stored in its file. Throws Error(input), also if the file has no vertices.
Mesh read_mesh_file(const std::filesystem::path& file);

/// Whether the coordinates and their squares are finite in single precision.
bool usable(const Eigen::Vector3d& position);
/// Removes points for which `bad(index)` is true, with their colors and normals, and returns their number.
std::size_t drop_points(Mesh& cloud, const std::function<bool(std::size_t)>& bad);

}  // namespace vantage
