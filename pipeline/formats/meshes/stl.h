#pragma once
#include <filesystem>

#include "scene/package/contents/mesh.h"

namespace vantage {

/// Reads an STL file, text at double precision or binary at single. Every corner is a
/// vertex of its own; normals and colors are skipped. Bytes behind a binary file's triangles are padding if
/// they are too few for one, or zero. Throws Error(input), also if the file is cut off.
Mesh read_stl(const std::filesystem::path& file);

}  // namespace vantage
