#pragma once
#include <cstddef>
#include <filesystem>
#include <string>

namespace vantage {

/// The file for one of `count` pictures: the output itself if there is one picture and the output is named
/// *.png, otherwise NAME.png in the output folder. Without an output, the file is in the current folder.
/// Throws Error(usage) if the output is not a folder and has the extension of an unsupported picture or video
/// format.
std::filesystem::path picture_file(const std::string& output, const std::string& name, std::size_t count);

/// Throws Error(usage) if a folder of pictures would have the extension of a picture or a video, unless that
/// folder exists. `expected` is the end of the error message.
void expect_folder_name(const std::filesystem::path& folder, const std::string& expected);

}  // namespace vantage
