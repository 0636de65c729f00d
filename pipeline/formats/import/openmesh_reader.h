#pragma once
#include <filesystem>

#include "scene/mesh.h"

namespace vantage {

/// Reads an OBJ, STL or OFF file by OpenMesh, in a process of its own: some files end it by an assertion, or
/// make it want all memory there is. Coordinates are in single precision; corners that no vertex has become
/// `no_vertex`. Throws Error(input).
Mesh read_by_openmesh(const std::filesystem::path& file);

}  // namespace vantage
