#pragma once
#include <filesystem>

namespace vantage {

/// Waits until a file, or the names in a folder, are on the disk. Does nothing if the file system does not
/// support it.
void flush_to_disk(const std::filesystem::path& path);

}  // namespace vantage
