#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace vantage {

/// Writes what a package holds as ordinary files into `folder`: photos/NAME.png (undistorted, level 0),
/// masks/NAME.png (angle, depth, border, consensus at half size), depth/NAME.exr (linear z, +inf unseen) and
/// mesh.ply (input coordinates, doubles). Only photos in `names`, all where it is empty. Throws Error.
void extract(const std::filesystem::path& package, const std::filesystem::path& folder,
             const std::vector<std::string>& names);

}  // namespace vantage
