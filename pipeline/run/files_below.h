#pragma once
#include <filesystem>
#include <vector>

namespace vantage {

/// Whether programs keep such a file or folder for themselves: .NAME (._NAME of macOS too), __MACOSX, @eaDir.
bool is_hidden(const std::filesystem::path& file);

/// The files in a folder and in its subfolders, `levels` deep (0: in the folder itself), sorted; hidden ones
/// are skipped, symbolic links are followed. Throws Error(input).
std::vector<std::filesystem::path> files_below(const std::filesystem::path& folder, int levels);

}  // namespace vantage
