#pragma once
#include <filesystem>
#include <vector>

namespace vantage {

/// Whether a file or folder is for the internal use of a program: .NAME (including ._NAME on macOS), __MACOSX
/// or @eaDir.
bool is_hidden(const std::filesystem::path& file);

/// The files in a folder and in its subfolders down to `levels` (0: only in the folder itself), sorted.
/// Hidden files and folders are skipped, and symbolic links are followed. Throws Error(input).
std::vector<std::filesystem::path> files_below(const std::filesystem::path& folder, int levels);

}  // namespace vantage
