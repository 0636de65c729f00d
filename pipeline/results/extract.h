#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace vantage {

/// Writes a package's contents as ordinary files to `folder`: photos/NAME.png (undistorted, level 0),
/// masks/NAME.png (angle, depth, border, consensus at half size), depth/NAME.exr (linear z, +inf: unseen) and
/// mesh.ply (input coordinates, doubles). NAME is without extension, unless other photos share it. Only the
/// photos in `names`; all if it is empty. Replaces only pictures and meshes that it may have written, with
/// `force` any file, but no input of the package. Throws Error.
void extract(const std::filesystem::path& package, const std::filesystem::path& folder,
             const std::vector<std::string>& names, bool force = false);

}  // namespace vantage
