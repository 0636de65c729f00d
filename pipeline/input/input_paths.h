#pragma once
#include <filesystem>
#include <vector>

#include "pipeline/input/scene_input.h"

namespace vantage {

/// Every file that a run may read: the mesh and its reference meshes, point clouds, the cameras, and all
/// photos in the folder, three levels deep, with their masks, whether used or not. Throws Error(input) if the
/// folder cannot be read.
std::vector<std::filesystem::path> input_paths(const InputFiles& files);

}  // namespace vantage
