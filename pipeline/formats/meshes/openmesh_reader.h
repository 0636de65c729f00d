#pragma once
#include <filesystem>

#include "scene/package/contents/mesh.h"

namespace vantage {

/// Reads a binary OFF file with OpenMesh, in a separate process: some files make it fail an assertion
/// or exhaust memory. Coordinates have single precision; corners that refer to no vertex become `no_vertex`.
/// Throws Error(input).
Mesh read_with_openmesh(const std::filesystem::path& file);

}  // namespace vantage
