#pragma once
#include <filesystem>

#include "scene/package/contents/mesh.h"

namespace vantage {

/// Reads an STL file: text in double precision, or binary in single precision. Every corner becomes a
/// separate vertex; normals and colors are skipped. Bytes after a binary file's triangles count as padding if
/// they are zero, or too few for another triangle. Throws Error(input), also if the file is truncated.
Mesh read_stl(const std::filesystem::path& file);

}  // namespace vantage
