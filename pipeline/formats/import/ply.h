#pragma once
#include <filesystem>

#include "scene/mesh.h"

namespace vantage {

/// Reads a PLY file (Turk 1994; text, binary of either byte order) with coordinates as precise as the file
/// has them; OpenMesh's reader rounds doubles to single precision and keeps no other properties. Faces become
/// fans, triangle strips triangles; red, green, blue and alpha become colours (floats from [0,1]), nx ny nz
/// normals as they are, every other single value of a vertex a scalar layer. Corners that no vertex has
/// become `no_vertex`. Throws Error(input) naming what was expected.
Mesh read_ply(const std::filesystem::path& file);
inline constexpr std::uint32_t no_vertex = 0xffffffffu;

}  // namespace vantage
