#pragma once
#include <filesystem>

#include "pipeline/scene_input.h"

namespace vantage {

/// Looks through a folder, three levels deep, for a mesh (mesh.* first, else the largest), cameras (COLMAP
/// first, then Bundler) and photos (a folder called images or photos first, else the one with the most).
/// Throws Error(input) saying what is missing.
InputFiles discover(const std::filesystem::path& folder);

/// Is this a photo's file name?
/// The stencil of a photo: NAME.mask.png beside it, with or without the photo's own extension in NAME, or
/// NAME.png in the folder `masks` beside the photos'; empty where there is none.
std::filesystem::path find_stencil(const std::filesystem::path& photo);

bool is_photo(const std::filesystem::path& file);

}  // namespace vantage
