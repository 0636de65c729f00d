#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "scene/package/output_file.h"

namespace vantage {

/// The files of a video's frames in a folder, NAME-0001.png and on, with links followed. Throws Error(usage)
/// like output_file().
std::vector<std::filesystem::path> frame_files(const std::filesystem::path& folder, const std::string& name,
                                               std::size_t count, const Inputs& inputs, bool force);

/// How many more frames of that name the folder has, of a longer video.
std::size_t frames_beyond(const std::filesystem::path& folder, const std::string& name, std::size_t count);

}  // namespace vantage
