#pragma once
#include <filesystem>

namespace vantage {

/// Waits until a file, or the names in a folder, are on the disk. Does nothing where the file system cannot.
void flush_to_disk(const std::filesystem::path& path);

}  // namespace vantage
