#pragma once
#include <filesystem>

namespace vantage {

/// Waits until a file, or the list of names in a folder, is on the disk. Does nothing if the file system does
/// not support it.
void flush_to_disk(const std::filesystem::path& path);

}  // namespace vantage
