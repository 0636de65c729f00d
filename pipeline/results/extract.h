#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace vantage {

/// Writes a package's contents as ordinary files to `folder`: photos/NAME.png (undistorted, level 0),
/// masks/NAME.png (angle, depth, border, consensus at half size), depth/NAME.exr (linear z, +inf: unseen) and
/// mesh.ply (input coordinates, doubles). Only the photos in `names`; all if it is empty. Throws Error.
void extract(const std::filesystem::path& package, const std::filesystem::path& folder,
             const std::vector<std::string>& names);

}  // namespace vantage
