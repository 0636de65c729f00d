#pragma once
#include <filesystem>
#include <vector>

#include "pipeline/input/scene_input.h"

namespace vantage {

/// Looks through a folder, three levels deep, for a mesh (mesh.* first, else the largest), cameras (COLMAP
/// first, then Bundler) and photos (a folder called images or photos first, else the one with the most).
/// Throws Error(input) saying what is missing.
InputFiles discover(const std::filesystem::path& folder);

/// The stencil of a photo: NAME.mask.png beside it, with or without the photo's own extension in NAME, or
/// NAME.png in the folder `masks` beside the photos'; empty where there is none.
std::filesystem::path find_stencil(const std::filesystem::path& photo);

/// Whether the file name is that of a photo, by its extension.
bool is_photo(const std::filesystem::path& file);

/// The camera files behind `cameras`: itself, or for a folder the COLMAP files in it, by name.
std::vector<std::filesystem::path> camera_files(const std::filesystem::path& cameras);

}  // namespace vantage
