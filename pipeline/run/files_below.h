#pragma once
#include <filesystem>
#include <vector>

namespace vantage {

/// Whether a file or folder is for a program's internal use: .NAME (including macOS's ._NAME), __MACOSX,
/// @eaDir.
bool is_hidden(const std::filesystem::path& file);

/// The files in a folder and in its subfolders, `levels` deep (0: only in the folder itself), sorted; hidden
/// ones are skipped, symbolic links are followed. Throws Error(input).
std::vector<std::filesystem::path> files_below(const std::filesystem::path& folder, int levels);

}  // namespace vantage
