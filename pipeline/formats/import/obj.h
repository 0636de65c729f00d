#pragma once
#include <filesystem>

#include "scene/mesh.h"

namespace vantage {

/// Reads a Wavefront OBJ file at double precision: vertices with their colors ("v x y z r g b", by
/// color_bytes()), normals and polygons, which become triangle fans. A line that ends in a backslash goes on
/// in the next. A vertex with several normals gets their sum. Corners that refer to no vertex become
/// `no_vertex`; lines of other kinds are skipped. Throws Error(input) with the line.
Mesh read_obj(const std::filesystem::path& file);

}  // namespace vantage
