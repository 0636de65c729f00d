#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "scene/package/output_file.h"

namespace vantage {

/// The files of a video's frames in a folder, from NAME-0001.png on, with links resolved. Throws Error(usage)
/// as output_file() does.
std::vector<std::filesystem::path> frame_files(const std::filesystem::path& folder, const std::string& name,
                                               std::size_t count, const Inputs& inputs, bool force);

/// The number of additional frames with that name in the folder, left over from a longer video.
std::size_t frames_beyond(const std::filesystem::path& folder, const std::string& name, std::size_t count);

}  // namespace vantage
