#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "scene/package/contents/mesh.h"

namespace vantage {

/// A corner that refers to no vertex.
inline constexpr std::uint32_t no_vertex = 0xffffffffu;

/// Reads a PLY file (Turk 1994; text, or binary of either byte order) at the file's precision, whereas
/// OpenMesh's reader rounds doubles to single precision and drops other properties. Faces become triangle
/// fans and strips become triangles. red, green, blue and alpha, or diffuse_red, r and so on (also with
/// alpha), become colors (see color_bytes()), nx, ny and nz become normals, unchanged, and every other scalar
/// vertex property becomes a scalar field. Alpha of faces is not read; if any face is not opaque, a line is
/// added to `warnings`. Throws Error(input) stating what was expected.
Mesh read_ply(const std::filesystem::path& file, std::vector<std::string>& warnings);

/// Whether the header lists faces; also true if the header is invalid, which read_ply() then reports.
bool ply_has_faces(const std::filesystem::path& file);

}  // namespace vantage
