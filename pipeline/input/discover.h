#pragma once
#include <filesystem>
#include <vector>

#include "pipeline/input/scene_input.h"

namespace vantage {

/// Searches a folder, three levels deep, for a mesh (preferably mesh.*, else the largest file), cameras
/// (in the order of camera_formats()) and the photos' folder (preferably one named images or photos, else
/// the one with the most photos). Throws Error(input) stating what is missing.
InputFiles discover(const std::filesystem::path& folder);

/// The stencil of a photo: NAME.mask.png in the photo's folder, or NAME.png in a folder `masks` next to that
/// folder. NAME is the photo's file name with or without its extension. Empty if there is no such file.
std::filesystem::path find_stencil(const std::filesystem::path& photo);

/// Whether the file's extension is that of a photo. False for stencils (NAME.mask.png).
bool is_photo(const std::filesystem::path& file);

/// The files that `cameras` stands for: the camera files in it if it is a folder, else the file itself.
std::vector<std::filesystem::path> camera_files(const std::filesystem::path& cameras);

}  // namespace vantage
