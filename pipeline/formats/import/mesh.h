#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "scene/mesh.h"

namespace vantage {

/// Reads a mesh: PLY, OBJ and text OFF at double precision, STL and binary OFF by OpenMesh in single
/// precision without its half-edge structure, so that non-manifold faces are kept. Polygons become triangle
/// fans. Triangles with repeated, missing or non-finite vertices, or coordinates of 1e18 or more, are dropped
/// and counted in `warnings`; vertices of no triangle are kept, but moved onto another vertex. Of a cloud,
/// points with such coordinates are dropped and counted. Also adds the coordinate_warnings. Normals have unit
/// length; missing ones are area-weighted means of the face normals; clouds without any have none. Throws
/// Error(input).
Mesh read_mesh(const std::filesystem::path& file, std::vector<std::string>& warnings);

/// Reads the points of a cloud, or the vertices of a mesh, with their colors and nothing else. Points with
/// coordinates that are not finite, or 1e18 or more, and those far from all others (values/main_box.h) are
/// dropped and counted in `warnings`. Throws Error(input), also if no point is left.
Mesh read_cloud(const std::filesystem::path& file, std::vector<std::string>& warnings);

}  // namespace vantage
