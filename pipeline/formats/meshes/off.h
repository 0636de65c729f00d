#pragma once
#include <filesystem>

#include "scene/package/contents/mesh.h"

namespace vantage {

/// Whether an OFF file is binary.
bool is_binary_off(const std::filesystem::path& file);

/// Reads a text OFF file in double precision (Geomview's OFF, COFF, NOFF, CNOFF and STOFF; the keyword is
/// optional). The result contains vertices, their normals and colors (see color_bytes(); with alpha if all
/// have it), and polygons, which become triangle fans. Colors of faces are skipped. Corners that refer to no
/// vertex become `no_vertex`. Throws Error(input) naming the line.
Mesh read_off(const std::filesystem::path& file);

}  // namespace vantage
