#pragma once
#include <cstddef>
#include <filesystem>
#include <vector>

#include "pipeline/input/scene_input.h"

namespace vantage {

/// The number of steps between two folders.
std::ptrdiff_t distance(const std::filesystem::path& from, const std::filesystem::path& to);

/// Finds the cameras among the files of a scan unless they are given, and also the photos' folder if there is
/// one camera file per image set. The file that fits the most photos is chosen, and the others are listed in
/// `notes`. Throws Error(input) if one of several camera files cannot be read.
void find_cameras(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& files,
                  InputFiles& found);

}  // namespace vantage
