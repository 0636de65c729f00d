#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "scene/package/contents/mesh.h"

namespace vantage {

/// Whether a file with this name may contain a point cloud because it is a PLY (which may also contain a
/// mesh), LAS, LAZ or E57.
bool is_cloud_file(const std::filesystem::path& file);

/// Reads the points of a cloud, or the vertices of a mesh, with their colors but no other attributes. Points
/// are dropped and counted in `warnings` if a coordinate is not finite or is 1e18 or more, or if they are far
/// from all others (base/values/main_box.h). Throws Error(input), also if no point remains, and for LAZ and
/// E57.
Mesh read_cloud(const std::filesystem::path& file, std::vector<std::string>& warnings);

}  // namespace vantage
